// SPDX-License-Identifier: Apache-2.0
// The stack of one context: mirrors rtl/traverse/frame_stack.sv.
#pragma once
#include <array>

#include "fixed.hpp"

namespace castray {

class FrameStack {
 public:
  explicit FrameStack(int depth = StackFrames) : depth_(depth) {}

  bool empty() const { return used_ == 0; }
  bool full() const { return used_ == depth_; }
  frame_t& top() { return frames_[used_ - 1]; }
  void push(const frame_t& frame) { frames_[used_++] = frame; }
  void drop() { --used_; }

 private:
  std::array<frame_t, StackFrames> frames_;
  int used_ = 0;
  int depth_;
};

}  // namespace castray
