// SPDX-License-Identifier: Apache-2.0
// Mirrors rtl/traverse/nearest.sv: the nearest hit of a ray.
#pragma once
#include "fixed.hpp"

namespace castray {

class Nearest {
 public:
  explicit Nearest(t_t tmax) { best_.t = tmax; }

  // Takes a result if it is nearer, or as near with a lower number. At exactly tmax it is not.
  void offer(const result_t& result) {
    if (result.t < best_.t || (result.t == best_.t && result.number < best_.number)) {
      best_ = result;
      found_ = true;
    }
  }

  bool found() const { return found_; }
  const result_t& best() const { return best_; }

 private:
  result_t best_;
  bool found_ = false;
};

}  // namespace castray
