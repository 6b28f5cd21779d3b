# SPDX-License-Identifier: Apache-2.0
# The C++ side: one library of the model and the host, one test binary a file under tb/.
LIB_SOURCES := $(shell find cpp_model -name '*.cpp' | sort)
LIB_OBJECTS := $(LIB_SOURCES:%.cpp=$(BUILD)/obj/%.o)
LIB         := $(BUILD)/libcastray.a

# What most of the host includes, read and instantiated once for all of it. It names files by their whole paths, so it is of no use
# in another tree, where a cache of compilations would offer it.
HOST_PCHED = -fPIC -fpch-instantiate-templates -Xclang -fno-pch-timestamp
HOST_PCH  := $(BUILD)/gen/host.pch
CLI_PCH   := $(BUILD)/gen/cli.pch
$(HOST_PCH): private PCH_OF := sim/precompiled.hpp
$(CLI_PCH): private PCH_OF := sim/cli/precompiled.hpp -O0
$(HOST_PCH) $(CLI_PCH): sim/precompiled.hpp sim/cli/precompiled.hpp $(RECORDS)
	@mkdir -p $(@D)
	@CCACHE_DISABLE=1 $(CXX) $(CXXFLAGS) $(HOST_PCHED) -x c++-header $(PCH_OF) -o $@
-include $(HOST_PCH:.pch=.d) $(CLI_PCH:.pch=.d)

# -fPIC: the Python package's shared library takes the same objects.
$(BUILD)/obj/%.o: %.cpp $(RECORDS) | $(HOST_PCH)
	@mkdir -p $(@D)
	@echo "  CXX   $<"
	@$(CXX) $(CXXFLAGS) -include-pch $(or $(PCH),$(HOST_PCH)) $(HOST_PCHED) -c $< -o $@

$(LIB): $(LIB_OBJECTS)
	@rm -f $@
	@ar rcs $@ $^

VERILATED_OBJ := $(BUILD)/obj/verilated-pic/verilated.o $(BUILD)/obj/verilated-pic/verilated_threads.o

# gold links faster than the default linker; both are of binutils.
LIBS      := -lembree3 -lassimp -lOpenImageIO -lOpenImageIO_Util -lImath-3_1 -latomic -lpthread
TEST_LIBS := -fuse-ld=gold -lgtest_main -lgtest -latomic -lpthread

# tb/<folder>/<unit>_test.cpp: with a unit of that name (or a wrapper) it is linked to its Verilated
# model; a comment line "// Verilator: <flags>" in the test adds flags. One that says "// Unit: <folder>/<unit>"
# is one more test of that unit, linked to the same model. Else it is a test of C++ only.
# The models of units are headers; only the tests of scenes, references and docs are linked to the
# library, and those of units that say "// Links the library." Those of the simulator and of whole
# frames: tools/core.mk.
TESTS       := $(shell find tb -name '*_test.cpp' | sort)
UNIT_TESTS  := $(foreach t,$(TESTS),$(if $(wildcard $(t:tb/%_test.cpp=rtl/%.sv) $(t:%_test.cpp=%_tb.sv)),$(t)))
# What tests say in comment lines "// Word: text", read once: file:Word:text, with "|" for each space of the text.
SAID        := $(shell sed -nE '/^\/\/ (Verilator|Unit|Cores|Long): /{s,^// ([A-Za-z]+): ,\1:,;s/ /|/g;F;p}; /^\/\/ (Links the library|Runs long)\.$$/{s/.*Links.*/Links:/;s/.*Runs.*/Runs:/;F;p}' $(TESTS) | paste -d: - -)
# said(Word,test): the text; saying(Word): the tests with such a line.
said         = $(subst |, ,$(patsubst $(2):$(1):%,%,$(filter $(2):$(1):%,$(SAID))))
saying       = $(filter $(TESTS),$(subst :, ,$(filter $(addsuffix :$(1):%,$(TESTS)),$(SAID))))
MORE_TESTS  := $(call saying,Unit)
SIM_TESTS   := $(filter tb/sim/% tb/frame/%,$(TESTS))
MODEL_TESTS := $(filter-out $(UNIT_TESTS) $(MORE_TESTS) $(SIM_TESTS),$(TESTS))

# A test takes longer to compile than to run, so it is compiled without optimisation, unless it says
# "// Runs long." or has a long form, "// Long: ...", and is none of the simulator (tools/core.mk). What most of
# them include is compiled once, for each of the two: it halves the time of a small test.
# It names files by their whole paths, so it is of no use in another tree, where a cache of compilations would offer it.
LONG_RUNS   := $(patsubst tb/%_test.cpp,%,$(filter-out $(SIM_TESTS),$(call saying,Runs) $(call saying,Long)))
PCH_FLAGS    = -fpch-instantiate-templates -Xclang -fno-pch-timestamp $(VERILATED_INC)
export CCACHE_SLOPPINESS := pch_defines,time_macros
TEST_PCHS   := $(BUILD)/gen/test-O0.pch $(BUILD)/gen/test-O2.pch
$(TEST_PCHS): $(BUILD)/gen/test%.pch: tb/common/precompiled.hpp $(RECORDS)
	@CCACHE_DISABLE=1 $(CXX) $(CXXFLAGS) $* -Itb/common $(PCH_FLAGS) -x c++-header $< -o $@
-include $(TEST_PCHS:.pch=.d)
# test_opt(test), test_pch(test), test_flags(test): how a test is compiled.
test_opt     = $(if $(filter $(1),$(LONG_RUNS)),-O2,-O0)
test_pch     = $(BUILD)/gen/test$(call test_opt,$(1)).pch
test_flags   = $(CXXFLAGS) $(call test_opt,$(1)) -include-pch $(call test_pch,$(1)) $(PCH_FLAGS) -Itb/common

# unit_model(unit): its Verilated model.
define unit_model
$(BUILD)/unit/$(1)/V$(notdir $(1)).o: $(wildcard tb/$(1)_tb.sv) $(wildcard rtl/$(1).sv) tb/$(1)_test.cpp tools/waivers.vlt $(PACKAGES) | $(VERILATED_PCHS)
	@echo "  VERILATE $(1)"
	$$(call verilate,$(notdir $(1)),$(BUILD)/unit/$(1),tb/$(dir $(1)),$(call said,Verilator,tb/$(1)_test.cpp))
-include $(BUILD)/unit/$(1)/V$(notdir $(1))__ver.d
endef
# unit_test(test,unit): the program of a test, linked to the unit's model.
define unit_test
$(BUILD)/unit/$(1)_test: tb/$(1)_test.cpp $(BUILD)/unit/$(2)/V$(notdir $(2)).o $(VERILATED_OBJ) $(call test_pch,$(1))
	@echo "  TEST  $(1)"
	@$(CXX) $(call test_flags,$(1)) -I$(BUILD)/unit/$(2) $$(filter %.cpp %.a %.o,$$^) -o $$@ $(TEST_LIBS) $$(if $$(filter $(LIB),$$^),$(LIBS))
endef
$(foreach u,$(UNIT_TESTS:tb/%_test.cpp=%),$(eval $(call unit_model,$(u)))$(eval $(call unit_test,$(u),$(u))))
$(foreach t,$(MORE_TESTS:tb/%_test.cpp=%),$(eval $(call unit_test,$(t),$(call said,Unit,tb/$(t)_test.cpp))))
$(patsubst tb/%_test.cpp,$(BUILD)/unit/%_test,$(filter $(UNIT_TESTS) $(MORE_TESTS),$(call saying,Links))): $(LIB)

LIB_TESTS := $(filter $(addprefix tb/,$(addsuffix /%,docs scene reference)),$(MODEL_TESTS))
$(LIB_TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test): $(LIB)
$(MODEL_TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test): $(BUILD)/unit/%_test: tb/%_test.cpp $(TEST_PCHS)
	@mkdir -p $(@D)
	@echo "  TEST  $*"
	@$(CXX) $(call test_flags,$*) $(filter %.cpp %.a,$^) -o $@ $(TEST_LIBS) $(if $(filter %.a,$^),$(LIBS))

-include $(LIB_OBJECTS:.o=.d) $(TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test.d)

ALL_TESTS := $(TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test)

# Whole frames first: they take longest.
TEST_PROGRAMS := $(wildcard tb/cli/*.sh) $(sort $(filter $(BUILD)/unit/frame/%,$(ALL_TESTS))) $(filter-out $(BUILD)/unit/frame/%,$(ALL_TESTS))
