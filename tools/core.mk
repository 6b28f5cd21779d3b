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

# How a core is compiled: those that only tests use so that to build and to run them takes least, others so that they run fastest.
# What Verilator calls slow runs once.
CORE_OPT ?= $(if $(filter $(filter-out $(CORES_RENDER),$(CORES_TEST)),$(1)),-O1,-O2)
# The options of one file of a variant.
core_opts = pch=$(lastword $(VERILATED_PCHS)); case $$file in *__Slow.cpp) opt=-O0 pch=$(firstword $(VERILATED_PCHS));; *__Trace__*) opt=-O1;; *) opt="$(call CORE_OPT,$(1))";; esac

# The largest files first.
$(BUILD)/verilated/%/Vcastray_core__ALL.a: $(CORE_RTL) tools/waivers.vlt | $(VERILATED_PCHS)
	@mkdir -p $(@D)
	@rm -f $(@D)/*.cpp $(@D)/*.o $@
	@echo "  VERILATE castray_core $*"
	@$(VERILATOR) --cc $(VERILATOR_FLAGS) $(if $(filter $(CORES_CHECKED),$*),,--no-assert) $(if $(call with_waves,$*),--trace-fst,-GGateClocks=1\'b1) --prefix Vcastray_core --Mdir $(@D) \
	  --output-split 15000 --top-module castray_core $(call core_parameters,$*) $(filter-out $(PACKAGES),$(CORE_RTL))
	@ls -S $(@D)/*.cpp | xargs -P $(JOBS) -I{} bash -c 'file={}; $(call core_opts,$*); echo "compile -c $$file"; \
	  exec $(VERILATED_CXX) $$opt -include-pch $$pch -c $$file -o $${file%.cpp}.o' | \
	  python3 tools/steps.py --compiled "$$(ls $(@D)/*.cpp | wc -l)" "castray_core $*"
	@ar rcs $@ $(@D)/*.o

# The Verilator library for shared objects.
VERILATED_PIC := $(addprefix $(BUILD)/obj/verilated-pic/,verilated.o verilated_dpi.o verilated_fst_c.o verilated_threads.o)

$(BUILD)/cores/%.so: $(BUILD)/verilated/%/Vcastray_core__ALL.a sim/core_instance.cpp $(wildcard sim/*.hpp) $(VERILATED_PIC) $(RECORDS)
	@mkdir -p $(@D)
	@$(CXX) $(filter-out -MMD -MP,$(CXXFLAGS)) -fPIC -fvisibility=hidden $(VERILATED_INC) -I$(dir $<) -shared \
	  sim/core_instance.cpp $< $(VERILATED_PIC) -lz -latomic -lpthread -o $@

# ---- Programs ----
SIM_PROGRAMS := castray castray_board make_scene bench
SIM_SOURCES  := $(filter-out sim/core_instance.cpp $(SIM_PROGRAMS:%=sim/%.cpp),$(wildcard sim/*.cpp sim/uio/*.cpp))
SIM_OBJECTS  := $(SIM_SOURCES:%.cpp=$(BUILD)/obj/%.o)
# What only reads arguments and calls the library, with templates that take long to optimise, is not optimised. The linker takes an
# inline function from the first object that has it: so these come last in a link. The rest of the command line and the bench: -O1.
CLI_OBJECTS  := $(patsubst %.cpp,$(BUILD)/obj/%.o,$(wildcard sim/cli/*.cpp))
COMMANDS     := $(patsubst %,$(BUILD)/obj/sim/%.o,castray bench make_scene $(addprefix cli/,arguments board_run compare compile info program query ray render report))
$(COMMANDS): private CXXFLAGS += -O0
$(COMMANDS): private PCH := $(CLI_PCH)
$(COMMANDS): | $(CLI_PCH)
$(filter-out $(COMMANDS),$(CLI_OBJECTS)) $(patsubst %.cpp,$(BUILD)/obj/%.o,$(wildcard sim/bench_*.cpp)): private CXXFLAGS += -O1
HOST_OBJECTS := $(SIM_OBJECTS) $(LIB_OBJECTS)
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

$(BUILD)/castray: $(HOST_OBJECTS) $(CLI_OBJECTS) $(BUILD)/obj/sim/castray.o
$(BUILD)/bench: $(HOST_OBJECTS) $(BUILD)/obj/sim/bench.o
$(BUILD)/castray $(BUILD)/bench:
	@echo "  LINK  $(@F)"
	@$(CXX) $(filter-out $(COMMANDS),$^) $(filter $(COMMANDS),$^) -o $@ $(SIM_LIBS)
$(BUILD)/make_scene: $(LIB_OBJECTS) $(BUILD)/obj/sim/make_scene.o
	@echo "  LINK  make_scene"
	@$(CXX) $^ -o $@ $(LIBS)

# ---- Tests: tb/sim of the simulator itself, tb/frame of whole frames on the test variants ----
# What runs long in them is in the objects, which stand before the test: it is not optimised.
$(SIM_TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test): $(BUILD)/unit/%_test: tb/%_test.cpp $(HOST_OBJECTS) $(CLI_OBJECTS) $(firstword $(TEST_PCHS))
	@mkdir -p $(@D)
	@echo "  TEST  $*"
	@$(CXX) $(call test_flags,$*) -Itb $(filter-out $(COMMANDS),$(filter %.o,$^)) $< $(filter $(COMMANDS),$^) -o $@ $(TEST_LIBS) $(SIM_LIBS)
# A test that runs the core says on which variants: "// Cores: l1c32t3p1m0 l3c32t3p2m128".
$(foreach t,$(SIM_TESTS),$(eval $(t:tb/%_test.cpp=$(BUILD)/unit/%_test): | $(call cores_files,$(call said,Cores,$(t)))))

.PHONY: cores
cores: $(call cores_files,$(CORES_TEST)) ## build the Verilated cores that the tests use
-include $(SIM_OBJECTS:.o=.d) $(CLI_OBJECTS:.o=.d) $(SIM_PROGRAMS:%=$(BUILD)/obj/sim/%.d)
