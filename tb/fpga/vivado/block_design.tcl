# SPDX-License-Identifier: Apache-2.0
# Block designs: cells, nets and interface nets, and the checks before a design is generated.
namespace eval fake {
  class design {} {validated 0 generated 0}
  class cell {} {vlnv {} preset 0}
  variable design ""
  variable nets {}        ;# pin -> net
  variable intf_nets {}   ;# interface -> the one at the other end

  command create_bd_design {} {name} {
    variable design
    open_project
    set design [create design $name]
    return $design
  }

  proc touch_design {} {
    variable design
    if {$design eq ""} {
      fail "no block design is open"
    }
    set_value $design validated 0
  }

  command create_bd_cell {-type: -vlnv:} {name} {
    touch_design
    if {[dict get $option -type] ne "ip"} {
      fail "create_bd_cell: only -type ip"
    }
    set vlnv [dict get $option -vlnv]
    find ip $vlnv
    set values [dict create vlnv $vlnv]
    dict for {parameter value} [ip_parameters $vlnv] {
      dict set values CONFIG.$parameter $value
    }
    return [create cell $name $values]
  }

  # Whether an object is a cell whose IP has this parameter; values are whole numbers.
  proc cell_property {object property} {
    return [expr {[class_of $object] eq "cell" && [string match CONFIG.* $property]
      && [dict exists [ip_parameters [value $object vlnv]] [string range $property 7 end]]}]
  }

  proc describe {cell} {
    set parameters {}
    foreach name [dict keys [ip_parameters [value $cell vlnv]]] {
      set number [value $cell CONFIG.$name]
      if {![string is integer -strict $number]} {
        fail "cell [name_of $cell]: $name is '$number'"
      }
      dict set parameters $name $number
    }
    return [ip_description [value $cell vlnv] $parameters]
  }

  command apply_bd_automation {-rule: -config:} {cell} {
    touch_design
    set rule [dict get $option -rule]
    if {$rule ne "xilinx.com:bd_rule:zynq_ultra_ps_e" || ![string match *:zynq_ultra_ps_e:* [value $cell vlnv]]} {
      fail "apply_bd_automation: no rule $rule for [name_of $cell]"
    }
    if {[dict get $option -config] ne "apply_board_preset 1"} {
      fail "apply_bd_automation: -config [dict get $option -config]"
    }
    if {[value [open_project] board_part] eq ""} {
      fail "apply_bd_automation: the project has no board, so there is no preset"
    }
    set_value $cell preset 1
  }

  command get_bd_cells {} {name} {
    return [find cell $name]
  }

  # CELL/NAME of what a cell's description holds under `what`, as pin:CELL/NAME.
  proc part_of_cell {what path} {
    lassign [split $path /] cell name
    find cell $cell
    if {![dict exists [describe cell:$cell] $what $name]} {
      fail "cell $cell has no [string trimright $what s] $name"
    }
    return [list [dict get [describe cell:$cell] $what $name] $path]
  }

  command get_bd_pins {} {path} {
    part_of_cell pins $path
    return pin:$path
  }

  command get_bd_intf_pins {} {path} {
    part_of_cell interfaces $path
    return intf:$path
  }

  command connect_bd_net {} {from to} {
    variable nets
    touch_design
    set drivers {}
    foreach pin [list $from $to] {
      lassign [lindex [part_of_cell pins [name_of $pin]] 0] direction($pin) width($pin)
      if {$direction($pin) eq "out"} {
        lappend drivers $pin
      } elseif {[dict exists $nets $pin]} {
        fail "connect_bd_net: [name_of $pin] is connected"
      }
    }
    if {[llength $drivers] != 1} {
      fail "connect_bd_net $from $to: [llength $drivers] drivers"
    }
    if {$width($from) != $width($to)} {
      fail "connect_bd_net $from $to: $width($from) bits to $width($to)"
    }
    foreach pin [list $from $to] {
      dict set nets $pin $drivers
    }
  }

  command connect_bd_intf_net {} {from to} {
    variable intf_nets
    touch_design
    set modes {}
    foreach end [list $from $to] {
      lassign [lindex [part_of_cell interfaces [name_of $end]] 0] mode protocol($end) width($end)
      lappend modes $mode
      if {[dict exists $intf_nets $end]} {
        fail "connect_bd_intf_net: [name_of $end] is connected"
      }
    }
    if {[lsort $modes] ne "master slave"} {
      fail "connect_bd_intf_net $from $to: [join $modes { to }]"
    }
    foreach {what one other} [list protocol $protocol($from) $protocol($to) width $width($from) $width($to)] {
      if {$one ne $other && $one ne "any" && $other ne "any"} {
        fail "connect_bd_intf_net $from $to: $what $one to $other"
      }
    }
    dict set intf_nets $from $to
    dict set intf_nets $to $from
  }

  # Everything that Vivado's validation would complain of in a design like this.
  command validate_bd_design {} {} {
    variable design
    variable nets
    variable intf_nets
    touch_design
    foreach cell [find cell *] {
      set parts [describe $cell]
      check_frequency $cell
      dict for {name description} [dict get $parts pins] {
        lassign $description direction width kind
        if {$direction eq "in" && $kind in {clock reset interrupt} && ![dict exists $nets pin:[name_of $cell]/$name]} {
          fail "validate_bd_design: [name_of $cell]/$name is not connected"
        }
      }
      foreach name [dict keys [dict get $parts interfaces]] {
        if {![dict exists $intf_nets intf:[name_of $cell]/$name]} {
          fail "validate_bd_design: [name_of $cell]/$name is not connected"
        }
      }
      if {[string match *:zynq_ultra_ps_e:* [value $cell vlnv]] && ![value $cell preset]} {
        fail "validate_bd_design: the processor has no board preset"
      }
    }
    check_one_clock
    check_addresses
    set_value $design validated 1
  }

  # A frequency that a package holds is not quite that of the processor's clock.
  proc check_frequency {cell} {
    variable packaged
    set vlnv [value $cell vlnv]
    if {[dict exists $packaged $vlnv] && [dict size [dict filter [dict get $packaged $vlnv] key bus_parameter:*/FREQ_HZ]] > 0} {
      fail "validate_bd_design: FREQ_HZ of [name_of $cell] is not 99999001, that of ps/pl_clk0"
    }
  }

  # Interfaces that are connected have one clock.
  proc check_one_clock {} {
    variable nets
    variable intf_nets
    dict for {from to} $intf_nets {
      foreach end [list $from $to] {
        set cell [lindex [split [name_of $end] /] 0]
        set clock($end) [dict get $nets pin:$cell/[lindex [part_of_cell interfaces [name_of $end]] 0 3]]
      }
      if {$clock($from) ne $clock($to)} {
        fail "validate_bd_design: $from and $to have two clocks"
      }
    }
  }

  command save_bd_design {} {} {
    variable design
    set name [name_of $design]
    set path [project_file [name_of [open_project]].srcs sources_1 bd $name $name.bd]
    file mkdir [file dirname $path]
    close [open $path w]
    create file $name.bd [dict create path $path]
  }

  # The design that a .bd file holds; it must be valid.
  proc design_of {file} {
    find file [name_of $file]
    set object design:[file rootname [name_of $file]]
    if {![exists $object] || ![value $object validated]} {
      fail "[name_of $file] holds no block design that was validated"
    }
    return $object
  }

  command generate_target {} {target files} {
    if {$target ne "all"} {
      fail "generate_target: no target $target"
    }
    set object [design_of $files]
    set_value $object generated 1
    set name [name_of $object]
    set path [project_file [name_of [open_project]].gen sources_1 bd $name hw_handoff $name.hwh]
    file mkdir [file dirname $path]
    write_handoff $path
  }

  command make_wrapper {-files: -top} {} {
    set name [name_of [design_of [dict get $option -files]]]
    set path [project_file [name_of [open_project]].gen sources_1 bd $name hdl ${name}_wrapper.v]
    file mkdir [file dirname $path]
    set file [open $path w]
    puts $file "module ${name}_wrapper;\nendmodule"
    close $file
    return $path
  }
}
