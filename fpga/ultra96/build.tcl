# SPDX-License-Identifier: Apache-2.0
# From the sources to a bitstream, in Vivado's batch mode; fpga/ultra96/bitstream.sh starts it.
# Everything is written below the folder `out`, which ends with NAME.bit, NAME.hwh and the two reports.

set oldest 2022.1
set newest 2024.2

set here [file dirname [file normalize [info script]]]
source [file join $here settings.tcl]
source [file join $here package_ip.tcl]
source [file join $here block_design.tcl]

# Runs synthesis or implementation and stops if it did not end well.
proc finish_run {run jobs args} {
  launch_runs $run -jobs $jobs {*}$args
  wait_on_run $run
  if {[get_property PROGRESS [get_runs $run]] ne "100%"} {
    stop "$run ended as [get_property STATUS [get_runs $run]]: see its runme.log"
  }
}

# A design that misses its clock leaves no bitstream.
proc check_timing {run report clock_mhz} {
  foreach {slack what} {STATS.WNS setup STATS.WHS hold} {
    set value [get_property $slack [get_runs $run]]
    if {$value < 0} {
      stop "timing failed at $clock_mhz MHz: the worst slack of $what is $value ns, see $report"
    }
  }
}

set settings [build_settings $argv]
dict with settings {}
set name castray_$board
set part [dict get $castray_boards $board part]

if {[package vcompare [version -short] $oldest] < 0} {
  stop "this is Vivado [version -short]; supported are $oldest to $newest"
}
if {[package vcompare [version -short] $newest] > 0 && ![string match $newest* [version -short]]} {
  puts "bitstream: Vivado [version -short] is newer than $newest, the newest that is supported"
}

set board_part [board_part $board [dict get $castray_boards $board files] $board_files]
source $registers
set work [file join $out $board]
package_ip $root [file join $work ip] $part $castray_registers

create_project -force $name [file join $work project] -part $part
set_property board_part $board_part [current_project]
set_property ip_repo_paths [list [file join $work ip ip]] [current_project]
update_ip_catalog
block_design $name [castray_vlnv $root] $settings
set design [get_files $name.bd]
generate_target all $design
add_files -norecurse [make_wrapper -files $design -top]
set_property top ${name}_wrapper [current_fileset]
update_compile_order -fileset sources_1

finish_run synth_1 $jobs
finish_run impl_1 $jobs
open_run impl_1
report_utilization -hierarchical -file [file join $out $name.utilization.txt]
report_timing_summary -file [file join $out $name.timing.txt]
close_design
check_timing impl_1 [file join $out $name.timing.txt] $clock_mhz
finish_run impl_1 $jobs -to_step write_bitstream

# Of one name, as PYNQ wants them.
set project [file join $work project]
file copy -force [file join $project $name.runs impl_1 ${name}_wrapper.bit] [file join $out $name.bit]
file copy -force [file join $project $name.gen sources_1 bd $name hw_handoff $name.hwh] [file join $out $name.hwh]
puts "bitstream: [file join $out $name.bit] and .hwh; $name.utilization.txt, $name.timing.txt beside them"
