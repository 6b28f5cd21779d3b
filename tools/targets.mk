# SPDX-License-Identifier: Apache-2.0
.DEFAULT_GOAL := help
.PHONY: help lint unit

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## /  \1\t/p' tools/targets.mk | expand -t 16

lint: $(LINTS) ## lint every module as its own top
	@echo "lint: $(words $(LINTS)) modules clean"

# One unit's test: make unit/isect/ray_prim
unit/%: $(BUILD)/unit/%_test
	$<
