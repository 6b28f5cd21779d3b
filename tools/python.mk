# SPDX-License-Identifier: Apache-2.0
# The Python package and its tests (docs/python.md).
SIM_LIB := $(BUILD)/libcastray_sim.a
$(SIM_LIB): $(SIM_OBJECTS)
	@rm -f $@
	@ar rcs $@ $^

# What python/CMakeLists.txt asks make, a line each: compiler, flags, archives, libraries, cores.
PYTHON_CORES = $(call cores_files,$(or $(CORES),$(CORES_RENDER)))
.PHONY: python-build-facts
python-build-facts:
	@echo "$(CXX)"
	@echo "$(filter-out -MMD -MP,$(patsubst -I%,-I$(CURDIR)/%,$(CXXFLAGS)))"
	@echo "$(SIM_LIB) $(LIB)"
	@echo "$(LIBS) -ldl"
	@echo "$(PYTHON_CORES)"

# A virtual environment with nothing but what `pip install .` puts there. What it takes of make is there before,
# so that the two do not build the same.
PACKAGE := $(call venv,castray)
$(PACKAGE): tools/requirements/castray.txt pyproject.toml tools/py_build.py tools/py_layout.py tools/sv_records.py $(PACKAGES) \
  fpga/ultra96/vlnv.txt python/CMakeLists.txt $(wildcard python/src/* python/castray/*.py) $(LIB) $(SIM_LIB) $(call cores_files,$(CORES_RENDER)) | $(PIP)
	@echo "  PIP   castray"
	@rm -rf $(@D)
	@python3 -m venv --without-pip $(@D)
	@env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS PIP_CONSTRAINT=$< $(pip_install) .
	@touch $@

# Its tests have their tools in an environment of their own, and the package from the first.
ALL_TESTS     += $(PACKAGE) $(call venv,python)
TEST_PROGRAMS += $(wildcard tb/python/*_test.sh)

.PHONY: python notebook
python: $(PACKAGE) $(call venv,python) $(BUILD)/castray $(call cores_files,$(CORES_CHECKED)) ## build, install and test the Python package
	@python3 tools/run_tests.py -j 1 tb/python/*_test.sh

notebook: $(PACKAGE) $(call venv,python) ## run the report's experiment anew: python/examples/report_experiment.ipynb
	@tb/python/run.sh tb/python/notebook.py python/examples/report_experiment.ipynb
