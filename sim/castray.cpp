// SPDX-License-Identifier: Apache-2.0
// The program: renders scenes on the simulated core, the model or the references, and looks into it.
#include "cli/command.hpp"

int main(int argc, char** argv) { return castray::cli::program(argc, argv); }
