# SPDX-License-Identifier: Apache-2.0
# Proofs: tb/formal, docs/formal.md. `make test` makes some of them: tb/cli/formal.sh.
.PHONY: formal formal-run
formal: ## prove the stream primitives and the AXI units, each proof shown to fail on planted faults: docs/formal.md
	@tools/setup.sh
	@$(MAKE) --no-print-directory formal-run

formal-run: $(call venv,yosys)
	@python3 tools/formal/prove.py -j $(JOBS) --page docs/formal.md

tests: $(call venv,yosys)
