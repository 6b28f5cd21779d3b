#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Some of the proofs that `make formal` makes, each with a fault planted that it must find.
set -euo pipefail
cd "$(dirname "$0")/../.."
exec python3 tools/formal/prove.py --fast
