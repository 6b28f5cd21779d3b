// SPDX-License-Identifier: Apache-2.0
// Drives units without handshake, whose stage k + 1 takes an item at bit k of an enable.
#pragma once
#include "dut.hpp"

namespace castray::tb {

// The enables as pipe_chain makes them: bubbles close up, a full chain waits for its sink.
class Chain {
 public:
  explicit Chain(int stages) : stages_(stages) {}
  bool last() const { return full_ >> (stages_ - 1) & 1; }
  // One cycle, in which an item is offered and the last one, if there is one, is taken.
  unsigned load(bool offered, bool taken) {
    unsigned ready = 0;
    bool open = taken;
    for (int k = stages_ - 1; k >= 0; --k) {
      open = open || !(full_ >> k & 1);
      ready |= unsigned{open} << k;
    }
    const unsigned load = (full_ << 1 | unsigned{offered}) & ready;
    full_ = (full_ & ~ready) | load;
    return load;
  }

 private:
  int stages_;
  unsigned full_ = 0;  // bit k: stage k + 1 holds an item
};

// Passes `count` items through: set(i) puts item i on the inputs, enable(bits) sets the enables,
// check(i) compares the outputs with item i's result, in every cycle in which the last stage holds it.
// While nothing enters, the inputs are those of any item.
template <class V, class Set, class Enable, class Check>
void run_chain(Dut<V>& dut, int stages, std::size_t count, Stalls stalls, Set set, Enable enable, Check check) {
  Gate source(stalls.source, stalls.burst, 1), sink(stalls.sink, stalls.burst, 2);
  std::mt19937 rng(3);
  Chain chain(stages);
  for (std::size_t sent = 0, done = 0; !testing::Test::HasFailure();) {
    const bool taken = sink.open();
    done += chain.last() && taken;
    if (done == count) return;
    const unsigned load = chain.load(sent < count && source.open(), taken);
    set(load & 1 ? sent++ : rng() % count);
    enable(load);
    dut.tick();
    if (chain.last()) check(done);
  }
}

// Passes `count` items through a unit that never stalls, with the source's gaps: set(k, i) puts on the
// inputs what item i brings to stage k + 1, or what another one would where none enters; check(k, i)
// compares what that stage has made of it.
template <class V, class Set, class Enable, class Check>
void run_straight(Dut<V>& dut, int stages, std::size_t count, Stalls stalls, Set set, Enable enable, Check check) {
  Gate source(stalls.source, stalls.burst, 1);
  std::mt19937 rng(3);
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> entering(static_cast<std::size_t>(stages), kNone);  // by stage
  for (std::size_t sent = 0, done = 0; done < count && !testing::Test::HasFailure();) {
    std::rotate(entering.begin(), entering.end() - 1, entering.end());
    entering[0] = sent < count && source.open() ? sent++ : kNone;
    unsigned load = 0;
    for (int k = 0; k < stages; ++k) {
      const std::size_t i = entering[static_cast<std::size_t>(k)];
      load |= unsigned{i != kNone} << k;
      set(k, i != kNone ? i : rng() % count);
    }
    enable(load);
    dut.tick();
    for (int k = 0; k < stages; ++k)
      if (const std::size_t i = entering[static_cast<std::size_t>(k)]; i != kNone) check(k, i);
    done += entering.back() != kNone;
  }
}

}  // namespace castray::tb
