# SPDX-License-Identifier: Apache-2.0
# Who sees what at which address in a block design.
namespace eval fake {
  variable assignments {}   ;# {space segment} -> {offset range}, or excluded

  command get_bd_addr_spaces {} {path} {
    part_of_cell spaces $path
    return space:$path
  }

  command get_bd_addr_segs {} {pattern} {
    regexp {^(\w+)/(.*)$} $pattern -> cell name
    find cell $cell
    set found [dict keys [dict get [describe cell:$cell] segments] $name]
    if {[llength $found] == 0} {
      fail "get_bd_addr_segs: cell $cell has no segment $name"
    }
    return [lmap segment $found {string cat segment:$cell/$segment}]
  }

  proc bytes {text} {
    if {[regexp {^(\d+)([KMG])$} $text -> number unit]} {
      return [expr {$number << [dict get {K 10 M 20 G 30} $unit]}]
    }
    return [expr {$text}]
  }

  # The slave interfaces that an address space reaches, through interconnects too.
  proc reached {space} {
    variable intf_nets
    set slaves {}
    set masters [lmap name [lindex [part_of_cell spaces [name_of $space]] 0] {
      string cat intf:[lindex [split [name_of $space] /] 0]/$name
    }]
    while {[llength $masters] > 0} {
      set masters [lassign $masters master]
      if {![dict exists $intf_nets $master]} {
        continue
      }
      set slave [dict get $intf_nets $master]
      set cell [lindex [split [name_of $slave] /] 0]
      if {![string match *:smartconnect:* [value cell:$cell vlnv]]} {
        lappend slaves $slave
        continue
      }
      foreach name [dict keys [dict get [describe cell:$cell] interfaces] M*] {
        lappend masters intf:$cell/$name
      }
    }
    return $slaves
  }

  # {interface range} of a segment, the interface as intf:CELL/NAME.
  proc segment {object} {
    regexp {^(\w+)/(.*)$} [name_of $object] -> cell name
    lassign [dict get [describe cell:$cell] segments $name] interface range
    return [list intf:$cell/$interface $range]
  }

  proc need_reach {space segment} {
    if {[lindex [segment $segment] 0] ni [reached $space]} {
      fail "[name_of $space] does not reach [name_of $segment]"
    }
  }

  command assign_bd_address {-offset: -range: -target_address_space:} {segment} {
    variable assignments
    touch_design
    set space [dict get $option -target_address_space]
    set offset [bytes [dict get $option -offset]]
    set range [bytes [dict get $option -range]]
    need_reach $space $segment
    if {$range < 4096 || ($range & ($range - 1)) || $offset % $range || $range > [bytes [lindex [segment $segment] 1]]} {
      fail "assign_bd_address [name_of $segment]: offset $offset, range $range"
    }
    if {[string match */Data [name_of $space]] && ($offset < 0xA0000000 || $offset + $range > 0xB0000000)} {
      fail "assign_bd_address [name_of $segment]: M_AXI_HPM0_FPD is at 0xA0000000 to 0xAFFFFFFF"
    }
    dict set assignments [list $space $segment] [list $offset $range]
  }

  command exclude_bd_addr_seg {-target_address_space:} {segment} {
    variable assignments
    touch_design
    need_reach [dict get $option -target_address_space] $segment
    dict set assignments [list [dict get $option -target_address_space] $segment] excluded
  }

  # Every segment that a space reaches is at an address, or left out by name.
  proc check_addresses {} {
    variable assignments
    foreach cell [find cell *] {
      foreach name [dict keys [dict get [describe $cell] spaces]] {
        set space space:[name_of $cell]/$name
        foreach slave [reached $space] {
          set other [lindex [split [name_of $slave] /] 0]
          foreach segment [dict keys [dict get [describe cell:$other] segments]] {
            set object segment:$other/$segment
            if {[lindex [segment $object] 0] eq $slave && ![dict exists $assignments [list $space $object]]} {
              fail "validate_bd_design: [name_of $object] has no address in [name_of $space]"
            }
          }
        }
      }
    }
  }

  # A line for each assignment, beside what PYNQ reads in the hardware handoff.
  proc assigned {} {
    variable assignments
    set lines {}
    dict for {pair place} $assignments {
      if {$place ne "excluded"} {
        lappend lines [format "%s sees %s at 0x%x, 0x%x bytes" {*}[lmap end $pair {name_of $end}] {*}$place]
      }
    }
    return [join $lines "\n"]
  }
}
