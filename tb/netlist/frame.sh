#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A teapot at 32x24 with the hierarchy through the netlist of a one-lane core: every pixel and every hit equals the model's.
set -euo pipefail
build/netlist/castray render scenes/teapot.json --engine rtl --lanes 1 --ports 1 --l2 0 --size 32x24 --check -o build/netlist/teapot.png
