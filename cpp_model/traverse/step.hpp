// SPDX-License-Identifier: Apache-2.0
// Where a ray of the hierarchy goes next: mirrors rtl/traverse/step.sv, for one context.
#pragma once
#include "traverse/frame_stack.hpp"

namespace castray {

inline bool some(const ref_t& ref) { return ref.kind != static_cast<std::uint64_t>(RefNone); }
inline bool some(const entry_t& entry) { return some(entry.target); }

inline visits_t visits_of(const start_t& start) {
  visits_t visits;
  visits.e0.target = start.first;
  visits.e1.target = start.second;
  return visits;
}

class Step {
 public:
  explicit Step(steps_t limit, int stack_depth = StackFrames) : limit_(limit), stack_(stack_depth) {}

  enum class Next { Visit, Again, Done, Failed };

  // One decision. No children: those of a leaf, or of one that decides again.
  Next decide(const visits_t& children, dist_t reach, bool stop) {
    if (some(children.e0)) {
      if (some(children.e1)) {
        if (stack_.full()) return fail(ErrStack);
        frame_t frame;
        frame.e0 = children.e1, frame.e1 = children.e2, frame.e2 = children.e3;
        stack_.push(frame);
      }
      return visit(children.e0.target);
    }
    if (stack_.empty() || stop) return Next::Done;
    frame_t& top = stack_.top();
    if (top.e0.least > reach) {  // and so are those behind it
      stack_.drop();
      return Next::Again;
    }
    const ref_t target = top.e0.target;
    top.e0 = top.e1, top.e1 = top.e2, top.e2 = entry_t{};
    if (!some(top.e0)) stack_.drop();
    return visit(target);
  }

  // The same until there is somewhere to go, or nothing more.
  Next next(const visits_t& children, dist_t reach, bool stop) {
    Next next = decide(children, reach, stop);
    while (next == Next::Again) next = decide({}, reach, stop);
    return next;
  }

  const ref_t& target() const { return target_; }   // of a visit
  steps_t nodes() const { return nodes_; }          // visited
  error_t error() const { return error_; }

 private:
  Next visit(const ref_t& target) {
    target_ = target;
    if (target.kind != static_cast<std::uint64_t>(RefLeaf)) {
      if (nodes_ >= limit_) return fail(ErrSteps);
      ++nodes_;
    }
    return Next::Visit;
  }
  Next fail(error_t error) {
    error_ = error;
    return Next::Failed;
  }

  steps_t limit_;
  FrameStack stack_;
  ref_t target_;
  steps_t nodes_ = 0;
  error_t error_ = ErrNone;
};

}  // namespace castray
