# SPDX-License-Identifier: Apache-2.0
# A stand-in for Vivado in batch mode. It keeps the state that Vivado keeps and stops with status 3 at whatever Vivado would
# refuse: a command, an option or a property that there is not, a file that does not exist, a port that the RTL does not have.
#
# What it knows of the core it is told by CASTRAY_FACTS, written by tb/fpga/top_facts.py from the synthesised wrapper, and by
# rtl/pkg/castray_reg_pkg.sv. The rest of the world:
#   FAKE_VERSION     Vivado's version                 FAKE_WNS, FAKE_WHS   slack after routing, ns
#   FAKE_BOARDS      board parts that are installed   FAKE_BARE_PACKAGER   1: maps and spaces are not made by the packager
namespace eval fake {
  variable here [file dirname [file normalize [info script]]]
  variable root [file normalize [file join $here .. .. ..]]
}
foreach part {commands project packager registers catalogue block_design addresses handoff runs} {
  source [file join $fake::here $part.tcl]
}

# Vivado's own command line.
set script ""
set argv_of_script {}
for {set i 0} {$i < [llength $argv]} {incr i} {
  switch -- [lindex $argv $i] {
    -mode {
      if {[lindex $argv [incr i]] ne "batch"} {
        fake::fail "-mode: only batch"
      }
    }
    -nojournal {}
    -log {close [open [lindex $argv [incr i]] w]}
    -source {set script [lindex $argv [incr i]]}
    -tclargs {
      set argv_of_script [lrange $argv $i+1 end]
      set i [llength $argv]
    }
    default {fake::fail "vivado: no option [lindex $argv $i]"}
  }
}
fake::need_file $script
set argv $argv_of_script
set argc [llength $argv]
if {[catch {source $script} message options]} {
  puts stderr "ERROR: $message\n[dict get $options -errorinfo]"
  exit 1
}
