# SPDX-License-Identifier: Apache-2.0
# For scripts that hold several tests: each case is counted like a GoogleTest's, by tools/run_tests.py.
#   case_of NAME COMMAND...   passes if the command does; what it prints is shown if it fails
#   ends                      the last line of a script
wrong=0
echo "[==========]"
case_of() {
  local name=$1 log
  shift
  # In a shell of its own, with -e: the first command that fails is the verdict.
  set +e
  log=$(set -e; "$@" 2>&1)
  local code=$?
  set -e
  if ((code == 0)); then echo "[       OK ] $name (0 ms)"; else echo "$log"; echo "[  FAILED  ] $name (0 ms)"; wrong=1; fi
}
ends() { exit $wrong; }
