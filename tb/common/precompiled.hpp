// SPDX-License-Identifier: Apache-2.0
// What most tests include, read and instantiated once for all of them (tools/cpp.mk). A test includes what it
// needs itself: this file only saves the compiler's time.
#pragma once
#include <gtest/gtest.h>
#include <verilated.h>

#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "castray_records.hpp"
#include "fixed.hpp"
