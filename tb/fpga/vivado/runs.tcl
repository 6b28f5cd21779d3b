# SPDX-License-Identifier: Apache-2.0
# Synthesis, implementation and what they leave behind.
namespace eval fake {
  class run {} {PROGRESS 0% STATUS {Not started} STATS.WNS {} STATS.WHS {} launched {} done {}}
  variable steps {synth_1 {synth_design} impl_1 {opt_design place_design route_design write_bitstream}}
  variable open_design ""

  proc create_runs {} {
    create run synth_1
    create run impl_1
  }

  command get_runs {} {name} {
    return [find run $name]
  }

  command launch_runs {-jobs: -to_step:} {run} {
    variable steps
    set object [find run $run]
    set all [dict get $steps $run]
    set last [expr {$run eq "impl_1" ? "route_design" : "synth_design"}]
    if {[dict exists $option -to_step]} {
      set last [dict get $option -to_step]
    }
    if {$last ni $all} {
      fail "launch_runs: $run has no step $last"
    }
    if {$run eq "impl_1" && [value run:synth_1 PROGRESS] ne "100%"} {
      fail "launch_runs impl_1: synth_1 is not done"
    }
    if {[value $object done] eq $last} {
      fail "launch_runs: $run is at $last already; reset it first"
    }
    if {$run eq "synth_1"} {
      need_design
    }
    set_value $object launched $last
  }

  # The top is the wrapper of a block design that was generated.
  proc need_design {} {
    set top [need_top]
    set design [string range $top 0 end-[string length _wrapper]]
    if {![exists design:$design] || ![value design:$design generated]} {
      fail "synth_1: the block design of $top was not generated"
    }
  }

  command wait_on_run {} {run} {
    set object [find run $run]
    set last [value $object launched]
    if {$last eq ""} {
      fail "wait_on_run: $run was not launched"
    }
    set_value $object PROGRESS 100%
    set_value $object STATUS "$last Complete!"
    set_value $object done $last
    set_value $object launched ""
    if {$run eq "impl_1"} {
      set_value $object STATS.WNS [environment FAKE_WNS 0.125]
      set_value $object STATS.WHS [environment FAKE_WHS 0.010]
    }
    if {$last eq "write_bitstream"} {
      set folder [project_file [name_of [open_project]].runs impl_1]
      file mkdir $folder
      close [open [file join $folder [value fileset:sources_1 top].bit] w]
    }
  }

  command open_run {} {run} {
    variable open_design
    set object [find run $run]
    if {[value $object PROGRESS] ne "100%"} {
      fail "open_run: $run is not done"
    }
    set open_design $run
  }

  command close_design {} {} {
    variable open_design
    need_open_design
    set open_design ""
  }

  proc need_open_design {} {
    variable open_design
    if {$open_design eq ""} {
      fail "no design is open"
    }
  }

  proc write_report {option text} {
    need_open_design
    set file [open [dict get $option -file] w]
    puts $file $text
    close $file
  }

  command report_utilization {-hierarchical -file:} {} {
    write_report $option "utilisation of a stand-in: no numbers"
  }

  command report_timing_summary {-file:} {} {
    write_report $option "WNS [value run:impl_1 STATS.WNS] ns, WHS [value run:impl_1 STATS.WHS] ns"
  }
}
