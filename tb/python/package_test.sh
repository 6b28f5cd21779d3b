#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The tests of the Python package, as pytest has them: tb/python/*_test.py.
exec "$(dirname "$0")/run.sh" -m pytest -q -s -p no:cacheprovider --durations=5 "$(dirname "$0")"/*_test.py
