#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The board's install is pure Python: a wheel without a compiled file, which drives whatever PYNQ has, and says
# what it cannot do.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
PIP_CONSTRAINT=tools/requirements/castray.txt build/venv/pip/bin/pip wheel --quiet --disable-pip-version-check --no-deps \
  --config-settings=wheel.cmake=false -w "$work" .
ls "$work"
[[ -f $(echo "$work"/castray-*-py3-none-any.whl) ]]
python3 -m zipfile -e "$work"/castray-*.whl "$work/package"
if find "$work/package" -name '*.so' | grep .; then echo "that is no pure Python"; exit 1; fi
cd "$work/package"
PYTHONPATH=$work/package exec "$OLDPWD/build/venv/castray/bin/python" -P - << 'EOF'
import castray
assert "/package/" in castray.__file__, castray.__file__
for call, error in ((lambda: castray.Core(sim=True), castray.NoSimulationError),
                    (lambda: castray.compile("scenes/teapot.json"), castray.NoCompilerError),
                    (lambda: castray.Core("castray.bit"), castray.NoBoardError)):
    try:
        call()
    except error as e:
        print(f"{error.__name__}: {e}")
    else:
        raise SystemExit(f"no {error.__name__}")
EOF
