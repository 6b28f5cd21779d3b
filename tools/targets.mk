# SPDX-License-Identifier: Apache-2.0
.DEFAULT_GOAL := help
.PHONY: help setup lint programs render render-run test test-run tests faults long long-run bench bench-run gallery hashes clean

RENDER_SCENE ?= scenes/teapot.json
RENDER_SIZE  ?= 320x240
UNITS        ?=

# numbered(goals): makes them; what it prints of each step says how many there are. The + before its recipe
# hands on the jobs: make does not look for $(MAKE) behind a call.
numbered = $(MAKE) --no-print-directory $(1) | python3 tools/steps.py $$($(MAKE) -n $(1) 2> /dev/null | python3 tools/steps.py --count)

help: ## list the targets
	@echo "make TARGET:"
	@sed -n 's/^\([a-z0-9-]*\):.*## /  \1\t/p' $(filter %.mk,$(MAKEFILE_LIST)) | expand -t 16
	@echo "  unit/FOLDER/NAME  build and run one unit's test, for example unit/isect/ray_prim"
	@echo "  JOBS=N            after a target: so many jobs side by side, else one a processor"

setup: ## install the Debian packages that are missing
	@tools/setup.sh

render: ## render the teapot on the Verilated core, compare with the model: build/teapot.png, .exr
	@tools/setup.sh
	@+$(call numbered,programs)
	@$(MAKE) --no-print-directory render-run

render-run: programs
	@$(BUILD)/castray render $(RENDER_SCENE) --engine rtl --size $(RENDER_SIZE) --check \
	  -o $(BUILD)/teapot.png --aov $(BUILD)/teapot.exr --json $(BUILD)/teapot.json

test: ## everything that must pass: lint, units, model, small frames; ends with N passed, N failed
	@tools/setup.sh
	@$(MAKE) --no-print-directory test-run

# What does not build counts as failed, so the build goes on behind an error. Scripts first: some take long, each on one processor.
test-run:
	@+built=0; $(call numbered,-k $(LINTS) programs tests) || built=1; \
	 ok=$$(ls $(LINTS) 2> /dev/null | wc -l); echo "  lint: $$ok of $(words $(LINTS)) tops clean"; \
	 python3 tools/run_tests.py -j $(JOBS) --passed $$ok --failed $$(($(words $(LINTS)) - ok + built)) \
	   $(filter %.sh,$(TEST_PROGRAMS)) $(filter-out %.sh,$(TEST_PROGRAMS))

lint: $(LINTS) ## lint every module and test wrapper as its own top, and the core as it is simulated
	@echo "lint: $(words $(LINTS)) tops clean"

programs: $(BUILD)/castray $(BUILD)/make_scene $(call cores_files,$(CORES_RENDER)) ## build the command-line programs

tests: $(ALL_TESTS) $(BUILD)/bench

long: ## the tests that have a long form, with it: docs/long.md (some 30 minutes)
	@tools/setup.sh
	@$(MAKE) --no-print-directory long-run

LONG_TESTS := $(call saying,Long)
long-run: $(LONG_TESTS:tb/%_test.cpp=$(BUILD)/unit/%_test)
	@python3 tools/long_runs.py -j $(JOBS) --page docs/long.md $(LONG_TESTS)

bench: ## full frames, ladder, sweeps, timings: build/bench.json and docs/bench.md (some 40 minutes)
	@tools/setup.sh
	@$(MAKE) --no-print-directory bench-run

bench-run: $(BUILD)/bench $(call cores_files,$(CORES_BENCH))
	@$(BUILD)/bench --json $(BUILD)/bench.json --page docs/bench.md $(BENCH_FLAGS)

faults: ## plant each fault of tb/faults; its unit's test must catch it (UNITS=isect/ray_prim: some)
	@python3 tools/plant_faults.py -j $(JOBS) $(UNITS)

# One unit's test: make unit/isect/ray_prim
unit/%: $(BUILD)/unit/%_test
	$<

GALLERY := teapot teapot_tight teapot_fit teapot_interior teapot_rotated teapot_flipped teapot_zoomed cube spheres
gallery: programs ## render the pictures of docs/gallery.md anew, with the model
	@mkdir -p docs/pictures
	@for scene in $(GALLERY); do $(BUILD)/castray render scenes/$$scene.json --engine model --size 320x240 -o docs/pictures/$$scene.png; done
	@$(BUILD)/castray render scenes/teapot.json --engine model --size 320x240 -o docs/pictures/teapot.png \
	  --nodes-map docs/pictures/teapot_nodes.png --tests-map docs/pictures/teapot_tests.png

hashes: programs ## write the SHA-256 of each scene's small frame anew: scenes/frames.sha256
	@tb/cli/hashes.sh --write

clean: ## remove everything that was built
	@rm -rf $(BUILD)
