#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# After `pip install .` in a fresh virtual environment, and from any folder: castray.Core(sim=True) renders the teapot
# on three lanes, every byte as it must be.
set -euo pipefail
cd "$(dirname "$0")/../.."
expected=$(sed -n 's/ .*teapot.pixels$//p' scenes/frames.sha256)
scene=$PWD/scenes/teapot.json python=$PWD/build/venv/castray/bin/python
cd /
exec "$python" - "$scene" "$expected" << 'EOF'
import hashlib, sys
import castray, numpy as np
core = castray.Core(sim=True)
frame = core.render(sys.argv[1], size=(80, 60))
words = np.dstack([frame.pixels, np.full((60, 80), 255, np.uint8)])
digest = hashlib.sha256(words.tobytes()).hexdigest()
print(core.description, frame.cycles, "cycles", digest)
sys.exit(core.lanes != 3 or digest != sys.argv[2])
EOF
