# SPDX-License-Identifier: Apache-2.0
# Place and route on an ECP5: the clocks that the units reach there. docs/pnr.md
.PHONY: pnr pnr-check pnr-record
pnr: $(call venv,yosys) $(call venv,pnr) ## place and route each unit and a small core on an ECP5, their clocks: docs/pnr.md (an hour and more)
	@python3 tools/pnr/pnr.py -j $(JOBS)

pnr-check: $(call venv,yosys) $(call venv,pnr) ## the units that miss their clock there, against the clocks in tools/pnr/budgets.json
	@python3 tools/pnr/pnr.py -j $(JOBS) --check

pnr-record: $(call venv,yosys) $(call venv,pnr) ## write these clocks and docs/pnr.md anew, from what was placed
	@python3 tools/pnr/pnr.py --record

# tb/cli/clocks.sh places a small unit.
tests: $(call venv,yosys) $(call venv,pnr)

# Some units: make pnr/isect/ray_prim
pnr/%: $(call venv,yosys) $(call venv,pnr)
	@python3 tools/pnr/pnr.py -j $(JOBS) $*
