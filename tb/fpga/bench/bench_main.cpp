// SPDX-License-Identifier: Apache-2.0
// Clock and reset for a module `bench` that checks itself: done_o ends it, failed_o says how.
#include <cstdio>

#include "Vbench.h"
#include "verilated.h"

int main() {
  VerilatedContext context;
  Vbench bench(&context);
  for (int cycle = 0; cycle < 1000000; ++cycle) {
    bench.rst_ni = cycle >= 16;
    bench.clk_i = 0;
    bench.eval();
    if (bench.rst_ni && bench.done_o) {
      std::printf("bench: %s after %d cycles\n", bench.failed_o ? "FAILED" : "passed", cycle);
      return bench.failed_o != 0;
    }
    bench.clk_i = 1;
    bench.eval();
  }
  std::printf("bench: FAILED, it does not end\n");
  return 1;
}
