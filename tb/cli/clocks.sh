#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What `make pnr-check` says of a unit that got slower: tb/synth/clocks_test.py.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 tb/synth/clocks_test.py
