// SPDX-License-Identifier: Apache-2.0
// What most of the host includes, read and instantiated once for all of it (tools/cpp.mk). A file includes what it needs itself:
// this one only saves the compiler's time.
#pragma once
#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "castray_records.hpp"
#include "fixed.hpp"
