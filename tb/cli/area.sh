#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What `make synth` makes of a netlist, and what `make synth-check` says of a budget: tb/synth/area_test.py.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 tb/synth/area_test.py
