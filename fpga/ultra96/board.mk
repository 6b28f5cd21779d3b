# SPDX-License-Identifier: Apache-2.0
# The Ultra96: its bitstream, and what of it is tested without Vivado (docs/board.md).
BOARD_TOP := fpga/ultra96/castray_top.v
LINTS     += $(BUILD)/lint/fpga/top_1port.ok $(BUILD)/lint/fpga/top_2ports.ok
# One lane: the wrapper's wires are the same for any number, and the core of three is a top of its own.
$(BUILD)/lint/fpga/top_1port.ok: PORTS_FLAG := -GLanes=1 -GPorts=1
$(BUILD)/lint/fpga/top_2ports.ok: PORTS_FLAG := -GLanes=1 -GPorts=2
$(BUILD)/lint/fpga/top_%.ok: $(BOARD_TOP) $(RTL) tools/waivers.vlt
	$(call lint,castray_top,$(PORTS_FLAG) $<)

# What the wrapper is once it is synthesised, for the tests.
TOP_FACTS := $(BUILD)/fpga/top.facts
$(TOP_FACTS): tb/fpga/top_facts.py $(BOARD_TOP) $(RTL) rtl/castray.f $(call venv,yosys)
	@echo "  YOSYS castray_top"
	@python3 $< $(YOSYS) -o $@

# The registers as the packager wants them.
BOARD_REGISTERS := $(BUILD)/ultra96/registers.tcl
$(BOARD_REGISTERS): fpga/ultra96/register_list.py tools/sv_records.py $(PACKAGES) docs/register-map.md
	@python3 $< $(PACKAGES) -o $@

# ---- The bitstream, with Vivado ----
.PHONY: bitstream
BOARD       ?= ultra96v2
CLOCK_MHZ   ?= 100
LANES       ?= $(call default_of,Lanes)
CONTEXTS    ?= $(call default_of,Contexts)
TILE_LOG2   ?= $(call default_of,TileLog2)
PORTS       ?= $(call default_of,Ports)
L2_KBYTES   ?= $(call default_of,L2Kbytes)
BOARD_FILES ?=
BOARD_OUT   ?= $(BUILD)/ultra96

bitstream: $(BOARD_REGISTERS) ## build the bitstream with Vivado: BOARD=ultra96v2 (or v1) CLOCK_MHZ= LANES= PORTS= (docs/board.md)
	@fpga/ultra96/bitstream.sh board=$(BOARD) out=$(abspath $(BOARD_OUT)) registers=$(abspath $<) clock_mhz=$(CLOCK_MHZ) lanes=$(LANES) \
	  contexts=$(CONTEXTS) tile_log2=$(TILE_LOG2) ports=$(PORTS) l2_kbytes=$(L2_KBYTES) jobs=$(JOBS) board_files=$(BOARD_FILES)

# ---- Tests ----
ALL_TESTS     += $(TOP_FACTS) $(BOARD_REGISTERS) $(call venv,board)
TEST_PROGRAMS += $(wildcard tb/fpga/*.sh)
