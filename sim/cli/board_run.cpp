// SPDX-License-Identifier: Apache-2.0
#include "board_run.hpp"

namespace castray::cli {

void BoardArguments::add_to(CLI::App& command) {
  const std::string group = "With --engine uio";
  command.add_option("--uio", options.uio, "how the device's name begins, or its path, /dev/uioN")
      ->capture_default_str()
      ->group(group);
  CLI::Option* const buffer =
      command.add_option("--udmabuf", options.udmabuf, "name of the u-dma-buf buffer; else the first")->group(group);
  command
      .add_option("--reserved", options.reserved,
                  "ADDRESS:BYTES of memory that the device tree reserves, instead of such a buffer")
      ->excludes(buffer)
      ->group(group);
  command.add_option("--timeout", timeout, "seconds without any progress of the core until it counts as hung")
      ->check(CLI::Range(0.001, 1e6))->capture_default_str()->group(group);
  command.add_flag("--poll", options.patience.poll, "do not wait for the interrupt")->group(group);
}

}  // namespace castray::cli
