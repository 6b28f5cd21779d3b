// SPDX-License-Identifier: Apache-2.0
// What most of the command line includes, read and instantiated once for all of it (tools/core.mk). A file includes what it
// needs itself: this one only saves the compiler's time.
#pragma once
#include <CLI/CLI.hpp>

#include "../precompiled.hpp"
