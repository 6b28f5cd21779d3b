// SPDX-License-Identifier: Apache-2.0
// What the programs return to the shell.
#pragma once

namespace castray::cli {

enum ExitCode : int {
  kOk = 0,
  kMismatch = 1,     // something that must be equal is not
  kBadInput = 2,     // an option, a scene, a picture to compare
  kDeviceError = 3,  // the core ended the job with an error code
  kHang = 4,         // the core is not there, did not come back, or is not of this build
  kBusRules = 5,     // the core broke a rule of its bus
  kBadOutput = 6,    // a file could not be written
  kInternal = 7,     // anything else
};

}  // namespace castray::cli
