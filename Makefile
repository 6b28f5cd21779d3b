# SPDX-License-Identifier: Apache-2.0
# castray: the one front door. `make help` lists the targets.
SHELL       := bash
.SHELLFLAGS := -euo pipefail -c
.DELETE_ON_ERROR:
.SECONDARY:

BUILD := build
JOBS  ?= $(shell nproc)
# A make that another started shares the jobs of that one.
ifeq ($(MAKELEVEL)$(filter -j% --jobs%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(JOBS)
endif

CXX      := clang++
OPT      := -O3
CXXFLAGS := -std=c++20 $(OPT) -march=native -Wall -Wextra -Wno-unused-parameter -MMD -MP \
            -Icpp_model -Isim -I$(BUILD)/gen -isystem /usr/include/Imath

include tools/venv.mk
include tools/rtl.mk
include tools/cpp.mk
include tools/core.mk
include tools/formal.mk
include fpga/ultra96/board.mk
include tools/python.mk
include tools/arm64.mk
include tools/targets.mk
include tools/synth.mk
include tools/pnr.mk
include tools/netlist.mk
include tools/width.mk
