#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Python with the package as it was installed, and the tools of its tests: tb/python/run.sh -m pytest ...
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p build/python/package
ln -sfn "$(echo "$PWD"/build/venv/castray/lib/python3*/site-packages/castray)" build/python/package/castray
PYTHONPATH=$PWD/build/python/package CASTRAY_CORES=$PWD/build/cores exec build/venv/python/bin/python "$@"
