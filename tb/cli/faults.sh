#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The faults that `make faults` plants: one for every RTL file, each where it can be planted.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 tools/fault_list.py
