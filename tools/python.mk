# SPDX-License-Identifier: Apache-2.0
# The Python package and its tests (docs/python.md).
#
# $(BUILD)/venv/castray is a virtual environment with nothing but what `pip install .` puts there; the tests'
# own tools are in $(BUILD)/venv/python and take the package from the first.
SIM_LIB := $(BUILD)/libcastray_sim.a
$(SIM_LIB): $(SIM_OBJECTS)
	@rm -f $@
	@ar rcs $@ $^

# What python/CMakeLists.txt asks make: compiler, flags, archives, libraries, cores.
PYTHON_CORES = $(call cores_files,$(or $(CORES),$(CORES_RENDER)))
.PHONY: python-build-facts
python-build-facts:
	@echo "$(CXX)"
	@echo "$(filter-out -MMD -MP,$(patsubst -I%,-I$(CURDIR)/%,$(CXXFLAGS)))"
	@echo "$(SIM_LIB) $(LIB)"
	@echo "$(LIBS) -ldl"
	@echo "$(PYTHON_CORES)"
