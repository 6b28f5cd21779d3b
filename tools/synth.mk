# SPDX-License-Identifier: Apache-2.0
# Synthesis by Yosys: what the units and the core take of the board's device. docs/area.md
.PHONY: synth synth-check synth-record
synth: $(call venv,yosys) ## synthesise the units and the core for 1 to 8 lanes: build/synth.json and docs/area.md
	@python3 tools/synth/synth.py -j $(JOBS)

synth-check: $(call venv,yosys) ## the units and the core of three lanes against their budgets, tools/synth/budgets.json
	@python3 tools/synth/synth.py -j $(JOBS) --check

synth-record: $(call venv,yosys) ## write these budgets anew
	@python3 tools/synth/synth.py -j $(JOBS) --record
	@python3 tools/integrate_page.py

# The parts of one unit: make synth/isect/ray_prim
synth/%: $(call venv,yosys)
	@python3 tools/synth/synth.py -j $(JOBS) $*
