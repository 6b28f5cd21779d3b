# SPDX-License-Identifier: Apache-2.0
# What is derived from the RTL: file lists, the C++ records, lint, and one verilated unit a test.
# CONFIG: the package of widths. For others: a copy of it, with a BUILD of its own (tools/width/).
CONFIG   ?= rtl/pkg/castray_cfg_pkg.sv
RTL      := $(patsubst rtl/pkg/castray_cfg_pkg.sv,$(CONFIG),$(shell grep -v '^//' rtl/castray.f))
PACKAGES := $(filter %_pkg.sv,$(RTL))
MODULES  := $(filter-out %_pkg.sv,$(RTL))
RTL_DIRS := $(sort $(dir $(MODULES)))

RECORDS := $(BUILD)/gen/castray_records.hpp
$(RECORDS): tools/sv_records.py $(PACKAGES)
	@python3 tools/sv_records.py $(PACKAGES) -o $@

# -fno-const-bit-op-tree: Verilator 5.006 miscompiles some XOR trees without it (docs/toolchain.md).
# Verilator itself, not the script around it, which takes longer to start than a small unit takes.
VERILATOR       := $(or $(shell command -v verilator_bin),verilator_bin)
VERILATOR_FLAGS := -Wall -fno-const-bit-op-tree --x-initial unique --x-assign unique --assert \
                   $(addprefix -y ,$(RTL_DIRS)) tools/waivers.vlt $(PACKAGES)
VERILATOR_ROOT  := $(or $(VERILATOR_ROOT),$(shell verilator --getenv VERILATOR_ROOT 2> /dev/null))
VERILATED_INC    = -isystem $(VERILATOR_ROOT)/include -isystem $(VERILATOR_ROOT)/include/vltstd

# How what Verilator writes is compiled, and its runtime once for all: the core's shared objects take the same. The header of
# every file of it is read once, for each optimisation that a header can be used with: -O0, and any other.
VERILATED_CXX   := $(CXX) -std=c++20 -march=native -fPIC -fvisibility=hidden -isystem $(VERILATOR_ROOT)/include -isystem $(VERILATOR_ROOT)/include/vltstd -w
VERILATED_PCHS  := $(BUILD)/gen/verilated-O0.pch $(BUILD)/gen/verilated-O1.pch
$(VERILATED_PCHS): %.pch: $(VERILATOR_ROOT)/include/verilated.h
	@mkdir -p $(@D)
	@CCACHE_DISABLE=1 $(VERILATED_CXX) $(patsubst verilated%,%,$(*F)) -Xclang -fno-pch-timestamp -x c++-header $< -o $@
$(BUILD)/obj/verilated-pic/%.o: $(VERILATOR_ROOT)/include/%.cpp
	@mkdir -p $(@D)
	@$(VERILATED_CXX) -O2 -DVM_TRACE=1 -DVM_TRACE_FST=1 -c $< -o $@

# verilate(unit,output folder,source folder of a wrapper,extra flags): V<unit>.h and V<unit>.o, all that Verilator writes as
# one file. A test bench wrapper tb/<folder>/<unit>_tb.sv, where there is one, is the top instead of the unit.
define verilate
	@mkdir -p $(2)
	@rm -f $(2)/*.cpp
	@$(VERILATOR) --cc $(VERILATOR_FLAGS) $(4) --prefix V$(1) --Mdir $(2) --MMD --MP \
	  --top-module $(if $(wildcard $(3)/$(1)_tb.sv),$(1)_tb $(3)/$(1)_tb.sv,$(1) $(shell grep -h '/$(1)\.sv$$' rtl/castray.f))
	@cd $(2) && printf '#include "%s"\n' V$(1)*.cpp > V$(1).all
	@$(VERILATED_CXX) -O1 -include-pch $(lastword $(VERILATED_PCHS)) -I$(2) -x c++ -c $(2)/V$(1).all -o $(2)/V$(1).o
	@sed -i '1s,^[^:]*:,$(2)/V$(1).o:,' $(2)/V$(1)__ver.d
endef

# Lint: every module and every wrapper of a test as its own top; the core as it is simulated: tools/core.mk.
WRAPPERS := $(shell find tb -name '*_tb.sv')
LINTS    := $(MODULES:rtl/%.sv=$(BUILD)/lint/%.ok) $(WRAPPERS:%.sv=$(BUILD)/lint/%.ok)
# lint(top,files)
define lint
	@mkdir -p $(@D)
	@rm -f $@
	@$(VERILATOR) --lint-only $(VERILATOR_FLAGS) --top-module $(1) $(2)
	@touch $@
endef
$(BUILD)/lint/%.ok: rtl/%.sv $(RTL) tools/waivers.vlt
	$(call lint,$(notdir $*),$<)
$(BUILD)/lint/tb/%.ok: tb/%.sv $(RTL) tools/waivers.vlt
	$(call lint,$(notdir $*),$<)
