# SPDX-License-Identifier: Apache-2.0
# The width study: errors and DSPs over the bits of each format. docs/width-study.md
.PHONY: width-study
width-study: $(LIB) $(call venv,plot) $(if $(RTL_POINTS),$(call venv,yosys)) ## errors and DSPs over the bits of each format: docs/width-study.md (20 minutes; RTL_POINTS=1: the RTL at three of them too)
	@$(BUILD)/venv/plot/bin/python tools/width/study.py -j $(JOBS) $(if $(RTL_POINTS),--rtl)
