#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The stand-in for Vivado refuses what Vivado would: each fault is planted in a copy of the scripts, and the build must stop with
# the message that belongs to it.
set -euo pipefail
cd "$(dirname "$0")/../.."
source tb/common/cases.sh
make -s build/fpga/top.facts build/ultra96/registers.tcl
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT

fresh() {
  rm -rf "${copy:?}"/*
  cp -r --parents fpga rtl tb/fpga/vivado "$copy"
  cp build/fpga/top.facts build/ultra96/registers.tcl "$copy"
}
build() {
  cd "$copy"
  env CASTRAY_FACTS="$copy/top.facts" PATH="$copy/tb/fpga/vivado:$PATH" fpga/ultra96/bitstream.sh board=ultra96v2 out="$copy/out" \
    registers="$copy/registers.tcl" clock_mhz=100 lanes=3 contexts=32 tile_log2=3 ports=2 l2_kbytes=128 jobs=1 board_files= 2>&1
}
refused() { # file, sed expression, words of the message
  fresh
  cp "$copy/$1" "$copy/before"
  sed -i "$2" "$copy/$1"
  if cmp -s "$copy/before" "$copy/$1"; then echo "nothing was planted in $1 by $2"; return 1; fi
  local said status=0
  said=$(build) || status=$?
  ((status != 0)) || { echo "built all the same: $said"; return 1; }
  grep -q -- "$3" <<< "$said" || { echo "it said otherwise: $said"; return 1; }
  [[ ! -e $copy/out/castray_ultra96v2.bit ]]
}
planted() { case_of "BitstreamFaults.$1" refused "fpga/ultra96/$2" "$3" "$4"; }

case_of BitstreamFaults.NoneBuilds eval 'fresh; build'

planted UnknownCommand build.tcl 's/^report_timing_summary/report_timing_sumary/' 'no command report_timing_sumary'
planted UnknownCommandUnderCatch build.tcl 's/^close_design/catch {close_designs}/' 'no command close_designs'
planted UnknownOption package_ip.tcl 's/-root_dir/-root_folder/' 'ipx::package_project: no option -root_folder'
planted UnknownProperty package_ip.tcl 's/set_property usage/set_property use/' 'a block has no property use'
planted UnknownParameterOfAnIp block_design.tcl 's/CONFIG.NUM_SI/CONFIG.NUM_S/' 'a cell has no property CONFIG.NUM_S'
planted TooManyArguments build.tcl 's/^open_run impl_1/open_run impl_1 impl_1/' 'open_run: too many arguments'

case_of BitstreamFaults.MissingFile refused rtl/castray.f '$a rtl/mem/no_such.sv' 'no file .*rtl/mem/no_such.sv'
planted MissingScript build.tcl 's/package_ip.tcl\]/package_core.tcl]/' 'couldn.t read file .*package_core.tcl'
case_of BitstreamFaults.AFileOfTheListIsLeftOut refused rtl/castray.f '/mem.line_cache.sv/d' 'the project does not hold .*line_cache.sv'

planted PortThatTheRtlDoesNotHave block_design.tcl 's,castray/interrupt,castray/irq,' 'cell castray has no pin irq'
planted PortsThatTheRtlDoesNotHave package_ip.tcl 's/m_axi_1_\*/m_axi_2_*/' 'there is no port m_axi_2_\*'
planted InterfaceThatTheRtlDoesNotHave block_design.tcl 's,castray/s_axi \*$,&,; s,control/M00_AXI castray/s_axi,control/M00_AXI castray/s_axi_control,' \
  'cell castray has no interface s_axi_control'
case_of BitstreamFaults.TheRtlLosesAPort refused top.facts '/^port m_axi_1_rlast /d' 'interface m_axi_1: there is no port m_axi_1_rlast'
case_of BitstreamFaults.ThePortIsNarrower refused top.facts 's/^port m_axi_0_wstrb output 16/port m_axi_0_wstrb output 8/' \
  'interface m_axi_0: the widths'

case_of BitstreamFaults.RegisterThatTheTableDoesNotHold refused registers.tcl 's/{Steps /{Stops /' 'the table of registers has no Stops'
case_of BitstreamFaults.RegisterAtAnotherPlace refused registers.tcl 's/{Steps 0x06c/{Steps 0x070/' 'register Steps is at 0x06c, not 0x070'
case_of BitstreamFaults.RegisterThatIsNotListed refused registers.tcl '/{Steps /d' 'there is no register \*/Steps'
case_of BitstreamFaults.CounterThatIsNotListed refused registers.tcl '/{CntTestsHigh /d' 'there is no register \*/CntTestsHigh'
case_of BitstreamFaults.BitThatTheTableDoesNotHold refused registers.tcl 's/{Brute 2/{Force 2/' 'has no bit Force of Options'
case_of BitstreamFaults.BitAtAnotherPlace refused registers.tcl 's/{Brute 2/{Brute 3/' 'bit Brute of Options is at 2, not 3'

planted ClockLeftOpen block_design.tcl 's, control/aclk,,' 'control/aclk is not connected'
planted ResetLeftOpen block_design.tcl 's,castray/aresetn},},' 'castray/aresetn is not connected'
planted InterruptLeftOpen block_design.tcl '/castray\/interrupt\] /d' 'ps/pl_ps_irq0 is not connected'
planted MemoryOf64Bits block_design.tcl 's/SAXIGP3__DATA_WIDTH 128/SAXIGP3__DATA_WIDTH 64/' 'width 128 to 64'
planted AddressForgotten block_design.tcl '/exclude_bd_addr_seg/d' 'HP1_QSPI has no address'
planted MoreMemoryThanThereIs block_design.tcl 's/-range 2G/-range 4G/' 'HP1_DDR_LOW: offset 0, range 4294967296'
planted NoBoardPreset block_design.tcl '/^  apply_bd_automation/d' 'the processor has no board preset'
planted AnotherPart settings.tcl 's/sbva484-1-i/sbva484-1-e/' 'does not have the part xczu3eg-sbva484-1-e'
planted FrequencyFixed package_ip.tcl '/^  leave_frequency_open/d' 'FREQ_HZ of castray is not 99999001'
planted NotValidated block_design.tcl '/^  validate_bd_design/d' 'no block design that was validated'
planted AnotherVlnv block_design.tcl 's/-vlnv $vlnv castray/-vlnv castray:castray:castray:1.0 castray/' 'there is no ip castray:castray:castray:1.0'
ends
