# SPDX-License-Identifier: Apache-2.0
# The hardware handoff (.hwh) of a block design: of what Vivado writes there, what PYNQ reads.
namespace eval fake {
  # <tag name="value" ...>, as a text.
  proc open_tag {tag attributes {end >}} {
    set text "<$tag"
    dict for {name value} $attributes {
      append text " $name=\"[string map {& &amp; < &lt; > &gt; \" &quot;} $value]\""
    }
    return $text$end
  }

  proc empty_tag {tag attributes} {
    return [open_tag $tag $attributes />]
  }

  proc named {tag name value} {
    return [empty_tag $tag [dict create NAME $name VALUE $value]]
  }

  # A register or a field with its properties, and what lies in it.
  proc described {tag name properties inside} {
    set lines [list [open_tag $tag [dict create NAME $name]]]
    dict for {property value} $properties {
      lappend lines [named PROPERTY [string toupper $property] $value]
    }
    return [join [concat $lines $inside "</$tag>"] "\n"]
  }

  proc handoff_registers {component} {
    set lines {}
    dict for {block properties} [dict filter $component key block:*] {
      lappend lines <ADDRESSBLOCKS> [open_tag ADDRESSBLOCK [dict create NAME [file tail [name_of $block]]]] <REGISTERS>
      dict for {register values} [dict filter $component key register:[name_of $block]/*] {
        set fields {}
        dict for {field field_values} [dict filter $component key field:[name_of $register]/*] {
          lappend fields [described FIELD [file tail [name_of $field]] $field_values {}]
        }
        set inside [concat <FIELDS> $fields </FIELDS>]
        lappend lines [described REGISTER [file tail [name_of $register]] $values $inside]
      }
      lappend lines </REGISTERS> </ADDRESSBLOCK> </ADDRESSBLOCKS>
    }
    return $lines
  }

  # What the processor sees: a range for each assignment in its address space.
  proc handoff_ranges {cell} {
    variable assignments
    set lines {}
    dict for {pair place} $assignments {
      lassign $pair space segment
      if {[string match space:[name_of $cell]/* $space] && $place ne "excluded"} {
        lassign $place offset range
        lassign [split [name_of [lindex [segment $segment] 0]] /] instance interface
        lappend lines [empty_tag MEMRANGE [dict create ADDRESSBLOCK [file tail [name_of $segment]] \
          BASEVALUE [format 0x%X $offset] HIGHVALUE [format 0x%X [expr {$offset + $range - 1}]] \
          INSTANCE $instance MEMTYPE REGISTER SLAVEBUSINTERFACE $interface]]
      }
    }
    return [concat <MEMORYMAP> $lines </MEMORYMAP>]
  }

  # The clocks of the processor as PYNQ asks for them; the divisors are the stand-in's.
  proc handoff_clocks {} {
    set lines {}
    for {set i 0} {$i < 4} {incr i} {
      lappend lines [named PARAMETER PSU__FPGA_PL${i}_ENABLE [expr {$i == 0}]]
      lappend lines [named PARAMETER PSU__CRL_APB__PL${i}_REF_CTRL__DIVISOR0 15]
      lappend lines [named PARAMETER PSU__CRL_APB__PL${i}_REF_CTRL__DIVISOR1 1]
    }
    return $lines
  }

  proc handoff_module {cell} {
    variable nets
    variable packaged
    set name [name_of $cell]
    set vlnv [value $cell vlnv]
    set kind [lindex [split $vlnv :] 2]
    set lines [list [open_tag MODULE [dict create FULLNAME /$name INSTANCE $name MODTYPE $kind VLNV $vlnv]]]
    lappend lines <PARAMETERS>
    foreach parameter [dict keys [ip_parameters $vlnv]] {
      if {![regexp {^PSU__(FPGA_PL\d_ENABLE)} $parameter]} {
        lappend lines [named PARAMETER $parameter [value $cell CONFIG.$parameter]]
      }
    }
    if {$kind eq "zynq_ultra_ps_e"} {
      lappend lines {*}[handoff_clocks]
    }
    lappend lines </PARAMETERS> <PORTS>
    dict for {pin driver} [dict filter $nets key pin:$name/*] {
      set signal [string map {/ _} [name_of $driver]]
      lappend lines [empty_tag PORT [dict create NAME [file tail [name_of $pin]] SIGNAME $signal]]
    }
    lappend lines </PORTS>
    if {[dict exists $packaged $vlnv]} {
      lappend lines {*}[handoff_registers [dict get $packaged $vlnv]]
    }
    return [join [concat $lines [handoff_ranges $cell] </MODULE>] "\n"]
  }

  proc write_handoff {path} {
    set file [open $path w]
    puts $file "<EDKSYSTEM>\n<EXTERNALPORTS/>\n<MODULES>"
    foreach cell [find cell *] {
      puts $file [handoff_module $cell]
    }
    puts $file "</MODULES>"
    foreach line [split [assigned] "\n"] {
      puts $file "<!-- $line -->"
    }
    puts $file "</EDKSYSTEM>"
    close $file
  }
}
