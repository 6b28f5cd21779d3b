# SPDX-License-Identifier: Apache-2.0
# Memory maps, address blocks and registers of a component. What a register may be stands in rtl/pkg/castray_reg_pkg.sv.
namespace eval fake {
  class map {}
  class block {usage {} range 0 width 0}
  class register {address_offset {} size {} access {} description {}}
  class field {bit_offset {} bit_width {} access {} description {}}

  # Name to value of the package's constants.
  proc package_constants {} {
    variable root
    set file [open [file join $root rtl pkg castray_reg_pkg.sv]]
    set constants {}
    foreach {all name hex number} [regexp -all -inline {int unsigned (\w+)\s*= (?:'h([0-9a-f]+)|(\d+));} [read $file]] {
      dict set constants $name [expr {$hex eq "" ? $number : "0x$hex"}]
    }
    close $file
    return $constants
  }

  # The offset that a name stands for; the upper word of what has 64 bits ends in High.
  proc offset_of {name} {
    set constants [package_constants]
    foreach {stem upper} [list $name 0 [regsub {High$} $name {}] 4] {
      if {[dict exists $constants Reg$stem] && $stem ne "Counters"} {
        return [expr {[dict get $constants Reg$stem] + $upper}]
      }
      if {[string match Cnt* $stem] && [dict exists $constants $stem]} {
        return [expr {[dict get $constants RegCounters] + 8 * [dict get $constants $stem] + $upper}]
      }
    }
    fail "ipx::add_register: the table of registers has no $name"
  }

  command ipx::get_memory_maps {-quiet -of_objects:} {pattern} {
    return [find map $pattern [quiet $option]]
  }

  command ipx::add_memory_map {} {name core} {
    return [create map $name]
  }

  command ipx::get_address_blocks {-quiet -of_objects:} {pattern} {
    return [find block [name_of [dict get $option -of_objects]]/$pattern [quiet $option]]
  }

  command ipx::add_address_block {} {name map} {
    return [create block [name_of $map]/$name]
  }

  command ipx::add_register {} {name block} {
    offset_of $name
    return [create register [name_of $block]/$name]
  }

  command ipx::add_field {} {name register} {
    set prefixes {Control Ctrl Ier Isr Isr Isr Options Option}
    set of [lindex [split [name_of $register] /] end]
    if {![dict exists $prefixes $of] || ![dict exists [package_constants] [dict get $prefixes $of]$name]} {
      fail "ipx::add_field: the table of registers has no bit $name of $of"
    }
    return [create field [name_of $register]/$name]
  }

  on_change register address_offset {
    set name [lindex [split [name_of $object] /] end]
    if {$value != [offset_of $name]} {
      fail "register $name is at [format 0x%03x [offset_of $name]], not $value"
    }
  }

  on_change field bit_offset {
    lassign [lrange [split [name_of $object] /] end-1 end] register name
    set prefix [dict get {Control Ctrl Ier Isr Isr Isr Options Option} $register]
    if {$value != [dict get [package_constants] $prefix$name]} {
      fail "bit $name of $register is at [dict get [package_constants] $prefix$name], not $value"
    }
  }

  # Every register of the table is listed, and complete.
  proc check_registers {} {
    foreach register [concat [find register *] [find field *]] {
      foreach property [dict keys [dict get $::fake::objects $register]] {
        if {[value $register $property] eq ""} {
          fail "[class_of $register] [name_of $register] has no $property"
        }
      }
      if {[value $register access] ni {read-only read-write}} {
        fail "[name_of $register]: access [value $register access]"
      }
    }
    foreach name [dict keys [package_constants] {Reg[A-Z]*}] {
      if {$name ni {RegAddrW RegCounters}} {
        find register */[string range $name 3 end]
      }
    }
    foreach name [dict keys [package_constants] {Cnt[A-Z]*}] {
      find register */$name
      find register */${name}High
    }
    foreach block [find block *] {
      if {[value $block usage] ne "register" || [value $block range] < 512 || [value $block width] != 32} {
        fail "address block [name_of $block]: usage, range or width"
      }
    }
  }
}
