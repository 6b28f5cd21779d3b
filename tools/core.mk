# SPDX-License-Identifier: Apache-2.0
# The simulator: the core Verilated once for each variant, the programs that drive it, their tests.
#
# A variant is named by its parameters: l3c32t3p2m128 has 3 lanes, 32 contexts each and tiles of 2^3 pixels
# a side. build/cores/<variant>.so is loaded by name when a program asks for it. <variant>w.so is the same core
# with waveforms, which cost time even while nothing is written.
default_of   = $(shell sed -n 's/.*unsigned Default$(1) *= \([0-9]*\);.*/\1/p' rtl/pkg/castray_cfg_pkg.sv)
CORES_RENDER := l$(call default_of,Lanes)c$(call default_of,Contexts)t$(call default_of,TileLog2)p$(call default_of,Ports)m$(call default_of,L2Kbytes)
CORES_TEST   := l1c32t3p1m0 l2c32t3p1m128 l3c32t3p2m128 l4c32t3p2m128
CORES_BENCH  := $(CORES_TEST) l1c1t3p2m128 l1c32t3p2m128 l2c32t3p2m128 l8c32t3p2m128 l3c32t2p2m128 l3c32t4p2m128 l3c32t3p2m0 l3c32t3p1m128 l3c32t3p1m0
cores_files   = $(1:%=$(BUILD)/cores/%.so)

CORE_RTL := $(RTL) sim/stream_probe.sv sim/stream_checks.sv
LINTS    += $(BUILD)/lint/sim.ok
$(BUILD)/lint/sim.ok: $(CORE_RTL) tools/waivers.vlt
	$(call lint,castray_core,$(filter-out $(PACKAGES),$(CORE_RTL)))

# The variant that is built with assertions (every stream's contract is checked while it runs) and waveforms,
# and with the clocks of hardware: in the others those of units at rest stand still (rtl/prim/clock_gate.sv).
CORES_CHECKED := l1c32t3p1m0
with_waves     = $(filter $(CORES_CHECKED) %w,$(1))
# Parameters of a variant by its name: l3c32t3p2m128 -> -GLanes=3 -GContexts=32 -GTileLog2=3 -GPorts=2 -GL2Kbytes=128
core_parameters = $(join -GLanes= -GContexts= -GTileLog2= -GPorts= -GL2Kbytes=,$(wordlist 1,5,$(subst l,,$(subst m, ,$(subst p, ,$(subst t, ,$(subst c, ,$(1:%w=%))))))))

# How a core is compiled that is to run long; tools/width/ builds some that run a few small frames.
CORE_OPT ?= -O3 -march=native

# The waveform writer first and with -O1: it is two thirds of the code and seldom runs. OPT_FAST,
# because -CFLAGS -O3 has no effect: the generated makefile's own -Os comes after it.
$(BUILD)/verilated/%/Vcastray_core__ALL.a: $(CORE_RTL) tools/waivers.vlt
	@mkdir -p $(@D)
	@rm -f $(@D)/*.cpp
	@echo "  VERILATE castray_core $*"
	@$(VERILATOR) --cc $(VERILATOR_FLAGS) $(if $(filter $(CORES_CHECKED),$*),,--no-assert) $(if $(call with_waves,$*),--trace-fst,-GGateClocks=1\'b1) --prefix Vcastray_core --Mdir $(@D) \
	  --output-split 15000 --top-module castray_core $(call core_parameters,$*) $(filter-out $(PACKAGES),$(CORE_RTL))
	@cd $(@D) && for step in $(if $(call with_waves,$*),"$$(ls *__Trace__*.cpp | sed 's/cpp$$/o/' | tr '\n' ' ')=-O1") "Vcastray_core__ALL.a=$(CORE_OPT)"; do \
	  MAKEFLAGS= make -f Vcastray_core.mk -j$(JOBS) $${step%%=*} CXX=$(CXX) USER_CPPFLAGS="-fPIC -fvisibility=hidden" \
	    OPT_FAST="$${step#*=}" OPT_SLOW="-O0" OPT_GLOBAL="-O1"; \
	  done | python3 $(CURDIR)/tools/steps.py --compiled "$$(ls *.cpp | wc -l)" "castray_core $*"
	@touch $@

# The Verilator library for shared objects.
VERILATED_PIC := $(addprefix $(BUILD)/obj/verilated-pic/,verilated.o verilated_dpi.o verilated_fst_c.o verilated_threads.o)
$(BUILD)/obj/verilated-pic/%.o: $(VERILATOR_ROOT)/include/%.cpp
	@mkdir -p $(@D)
	@$(CXX) -std=c++20 -O2 -fPIC -fvisibility=hidden $(VERILATED_INC) -DVM_TRACE=1 -DVM_TRACE_FST=1 -c $< -o $@

$(BUILD)/cores/%.so: $(BUILD)/verilated/%/Vcastray_core__ALL.a sim/core_instance.cpp $(wildcard sim/*.hpp) $(VERILATED_PIC) $(RECORDS)
	@mkdir -p $(@D)
	@$(CXX) $(filter-out -MMD -MP,$(CXXFLAGS)) -fPIC -fvisibility=hidden $(VERILATED_INC) -I$(dir $<) -shared \
	  sim/core_instance.cpp $< $(VERILATED_PIC) -lz -latomic -lpthread -o $@

# ---- Programs ----
SIM_PROGRAMS := castray castray_board make_scene bench
SIM_SOURCES  := $(filter-out sim/core_instance.cpp $(SIM_PROGRAMS:%=sim/%.cpp),$(wildcard sim/*.cpp sim/uio/*.cpp))
SIM_OBJECTS  := $(SIM_SOURCES:%.cpp=$(BUILD)/obj/%.o)
# The command line and the bench run once; what they time is in the library. Not -O0: the linker may take an inline function
# from any object.
$(BUILD)/obj/sim/cli/%.o $(BUILD)/obj/sim/bench%.o: CXXFLAGS += -O1
CLI_OBJECTS  := $(patsubst %.cpp,$(BUILD)/obj/%.o,$(wildcard sim/cli/*.cpp))
CLI_PCH      := $(BUILD)/gen/cli.pch
CLI_PCHED     = -fpch-instantiate-templates -Xclang -fno-pch-timestamp
$(CLI_PCH): sim/cli/precompiled.hpp
	@mkdir -p $(@D)
	@CCACHE_DISABLE=1 $(CXX) $(CXXFLAGS) -O1 -fPIC $(CLI_PCHED) -x c++-header $< -o $@
$(CLI_OBJECTS): $(CLI_PCH)
$(CLI_OBJECTS): private CXXFLAGS += -include-pch $(CLI_PCH) $(CLI_PCHED)
-include $(CLI_PCH:.pch=.d)
SIM_LIBS     := $(LIBS) -ldl -rdynamic

# The commit that a picture's metadata names; written anew only when it changed.
COMMIT := $(BUILD)/gen/castray_commit.hpp
.PHONY: commit
commit: ;
$(COMMIT): commit
	@mkdir -p $(@D)
	@printf '#pragma once\ninline constexpr const char* kCommit = "%s";\n' \
	  "$$(git describe --always --dirty 2> /dev/null || echo unknown)" > $@.new
	@if cmp -s $@ $@.new; then rm $@.new; else mv $@.new $@; fi
$(CLI_OBJECTS) $(BUILD)/obj/sim/bench.o: | $(COMMIT)

$(BUILD)/castray: $(BUILD)/obj/sim/castray.o $(CLI_OBJECTS) $(SIM_OBJECTS) $(LIB)
	@echo "  LINK  castray"
	@$(CXX) $(filter %.o %.a,$^) -o $@ $(SIM_LIBS)
$(BUILD)/bench: $(BUILD)/obj/sim/bench.o $(SIM_OBJECTS) $(LIB)
	@echo "  LINK  bench"
	@$(CXX) $(filter %.o %.a,$^) -o $@ $(SIM_LIBS)
$(BUILD)/make_scene: $(BUILD)/obj/sim/make_scene.o $(LIB)
	@echo "  LINK  make_scene"
	@$(CXX) $(filter %.o %.a,$^) -o $@ $(LIBS)

# ---- Tests: tb/sim of the simulator itself, tb/frame of whole frames on the test variants ----
$(SIM_TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test): $(BUILD)/unit/%_test: tb/%_test.cpp $(CLI_OBJECTS) $(SIM_OBJECTS) $(LIB) $(TEST_PCHS)
	@mkdir -p $(@D)
	@echo "  TEST  $*"
	@$(CXX) $(call test_flags,$*) -Itb $(filter %.cpp %.o %.a,$^) -o $@ $(TEST_LIBS) $(SIM_LIBS)
# A test that runs the core says on which variants: "// Cores: l1c32t3p1m0 l3c32t3p2m128".
$(foreach t,$(SIM_TESTS),$(eval $(t:tb/%_test.cpp=$(BUILD)/unit/%_test): | $(call cores_files,$(call said,Cores,$(t)))))

.PHONY: cores
cores: $(call cores_files,$(CORES_TEST)) ## build the Verilated cores that the tests use
-include $(SIM_OBJECTS:.o=.d) $(CLI_OBJECTS:.o=.d) $(SIM_PROGRAMS:%=$(BUILD)/obj/sim/%.d)
