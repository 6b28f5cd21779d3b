# SPDX-License-Identifier: Apache-2.0
# The synthesised netlists of the units, in the RTL's place in the units' own tests. docs/netlist.md
CELLS_SIM     = $(shell find $(BUILD)/venv/yosys/lib -path '*/share/xilinx/cells_sim.v')
CELL_MODELS  := $(wildcard tb/netlist/*.sv)
NETLIST_UNITS := $(UNIT_TESTS:tb/%_test.cpp=%)
# In make test: a multiplier with its DSPs, queues in LUT memory, a stack in block memory.
NETLIST_SHORT := math/mul27 prim/stream_fifo traverse/frame_stack

NETLIST_FLAGS := -fno-const-bit-op-tree -Wno-lint -Wno-style -Wno-UNOPTFLAT -Wno-INITIALDLY --x-initial unique --x-assign unique --assert

# netlist_model(unit): its netlist, verilated under the names of the RTL's model.
define netlist_model
$(BUILD)/netlist/$(1)/V$(notdir $(1))__ALL.a: $(wildcard tb/$(1)_tb.sv) $(RTL) $(CELL_MODELS) tools/waivers.vlt $(call venv,yosys)
	@echo "  NETLIST $(1)"
	@python3 tools/synth/netlist.py $(1) $(patsubst -G%,%,$(filter -G%,$(call said,Verilator,tb/$(1)_test.cpp))) -o $(BUILD)/netlist/$(1).v
	@mkdir -p $$(@D)
	@$(VERILATOR) --cc $(NETLIST_FLAGS) --prefix V$(notdir $(1)) --Mdir $$(@D) --top-module $(notdir $(1))$(if $(wildcard tb/$(1)_tb.sv),_tb) \
	  $(CELL_MODELS) $$(CELLS_SIM) $(BUILD)/netlist/$(1).v > $$(@D)/verilator.log 2>&1 || { tail -5 $$(@D)/verilator.log; exit 1; }
	@MAKEFLAGS= make -s -C $$(@D) -f V$(notdir $(1)).mk V$(notdir $(1))__ALL.a CXX=$(CXX) OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O1 > /dev/null
endef
# netlist_program(test,unit): the program of a unit's test, linked to the netlist.
define netlist_program
$(BUILD)/netlist/$(1)_test: tb/$(1)_test.cpp $(BUILD)/netlist/$(2)/V$(notdir $(2))__ALL.a $(VERILATED_OBJ) $(RECORDS)
	@echo "  TEST  netlist of $(1)"
	@$(CXX) $(filter-out -MMD -MP,$(CXXFLAGS)) -O1 -Itb/common $(VERILATED_INC) -I$(BUILD)/netlist/$(2) $$(filter %.cpp %__ALL.a %.o,$$^) -o $$@ \
	  $(if $(filter tb/$(1)_test.cpp,$(call saying,Links)),$(LIB) $(TEST_LIBS) $(LIBS),$(TEST_LIBS))
endef
$(foreach u,$(NETLIST_UNITS),$(eval $(call netlist_model,$(u)))$(eval $(call netlist_program,$(u),$(u))))

# The whole core of one lane: castray finds it in the folder cores beside itself.
NETLIST_CORE := l1c32t3p1m0
$(BUILD)/netlist/core/Vcastray_core__ALL.a: $(RTL) $(CELL_MODELS) $(call venv,yosys)
	@echo "  NETLIST castray_core $(NETLIST_CORE)"
	@python3 tools/synth/netlist.py castray_core $(patsubst -G%,%,$(call core_parameters,$(NETLIST_CORE))) -o $(BUILD)/netlist/core.v
	@mkdir -p $(@D)
	@$(VERILATOR) --cc $(NETLIST_FLAGS) --output-split 15000 --prefix Vcastray_core --Mdir $(@D) --top-module castray_core \
	  $(CELL_MODELS) $(CELLS_SIM) $(BUILD)/netlist/core.v > $(@D)/verilator.log 2>&1 || { tail -5 $(@D)/verilator.log; exit 1; }
	@MAKEFLAGS= make -s -j$(JOBS) -C $(@D) -f Vcastray_core.mk Vcastray_core__ALL.a CXX=$(CXX) USER_CPPFLAGS="-fPIC -fvisibility=hidden" \
	  OPT_FAST=-O1 OPT_SLOW=-O0 OPT_GLOBAL=-O1 > /dev/null
$(BUILD)/netlist/cores/$(NETLIST_CORE).so: $(BUILD)/netlist/core/Vcastray_core__ALL.a sim/core_instance.cpp $(wildcard sim/*.hpp) $(VERILATED_PIC) $(RECORDS)
	@mkdir -p $(@D)
	@$(CXX) $(filter-out -MMD -MP,$(CXXFLAGS)) -fPIC -fvisibility=hidden $(VERILATED_INC) -I$(dir $<) -shared \
	  sim/core_instance.cpp $< $(VERILATED_PIC) -lz -latomic -lpthread -o $@
$(BUILD)/netlist/castray: $(BUILD)/castray
	@mkdir -p $(@D)
	@cp $< $@

.PHONY: netlist-test
netlist-test: $(call venv,yosys) ## the units' own tests on their synthesised netlists, a small frame on a whole core's: docs/netlist.md
	@-$(MAKE) --no-print-directory -k $(NETLIST_UNITS:%=$(BUILD)/netlist/%_test) $(BUILD)/netlist/castray $(BUILD)/netlist/cores/$(NETLIST_CORE).so
	@python3 tools/run_tests.py -j $(JOBS) --limit 3600 tb/netlist/frame.sh $(NETLIST_UNITS:%=$(BUILD)/netlist/%_test)

# One unit's: make netlist/isect/accept
netlist/%: $(BUILD)/netlist/%_test
	$<

tests: $(NETLIST_SHORT:%=$(BUILD)/netlist/%_test)
TEST_PROGRAMS += $(NETLIST_SHORT:%=$(BUILD)/netlist/%_test)
