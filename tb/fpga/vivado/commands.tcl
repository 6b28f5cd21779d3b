# SPDX-License-Identifier: Apache-2.0
# How the stand-in declares a command: its options, its arguments, what it does.
namespace eval fake {
  # Ends the run. No script can catch it.
  proc fail {message} {
    puts stderr "fake vivado: $message"
    exit 3
  }

  proc need_file {name} {
    if {![file exists $name]} {
      fail "no file $name"
    }
  }

  # command NAME {-flag -option:} {argument optional? rest*} body
  # In the body `option` is the dictionary of the options that were given.
  proc command {name options arguments body} {
    set names {}
    foreach argument $arguments {
      lappend names [string trimright $argument ?*]
    }
    namespace eval ::[namespace qualifiers $name] {}
    # tclint-disable-next-line command-args
    proc [body_of $name] [concat option $names] $body
    # tclint-disable-next-line command-args
    proc ::$name args [format {fake::call {%s} {%s} {%s} $args} $name $options $arguments]
  }

  proc body_of {name} {
    return ::fake::run_[string map {:: _} $name]
  }

  proc call {name options arguments given} {
    set option {}
    set values {}
    while {[llength $given] > 0} {
      set word [lindex $given 0]
      set given [lrange $given 1 end]
      if {![string match {-[a-z]*} $word]} {
        lappend values $word
      } elseif {$word in $options} {
        dict set option $word 1
      } elseif {"$word:" in $options} {
        if {[llength $given] == 0} {
          fail "$name: $word wants a value"
        }
        dict set option $word [lindex $given 0]
        set given [lrange $given 1 end]
      } else {
        fail "$name: no option $word"
      }
    }
    return [[body_of $name] $option {*}[bound $name $arguments $values]]
  }

  # The values for the named arguments; what is optional and missing is empty.
  proc bound {name arguments values} {
    set result {}
    foreach argument $arguments {
      if {[string match {*\*} $argument]} {
        lappend result $values
        set values {}
      } elseif {[llength $values] > 0} {
        lappend result [lindex $values 0]
        set values [lrange $values 1 end]
      } elseif {[string match {*\?} $argument]} {
        lappend result ""
      } else {
        fail "$name: the argument $argument is missing"
      }
    }
    if {[llength $values] > 0} {
      fail "$name: too many arguments: $values"
    }
    return $result
  }

  # ---- Objects: class:name, each with the properties of its class ----
  variable objects {}
  variable classes {}

  # class NAME {property default ...} [{read-only property default ...}]
  proc class {name writable {fixed {}}} {
    variable classes
    dict set classes $name [dict create writable [dict keys $writable] defaults [dict merge $writable $fixed]]
  }

  proc create {class name {values {}}} {
    variable objects
    variable classes
    set object $class:$name
    if {[dict exists $objects $object]} {
      fail "there is a $class $name already"
    }
    dict set objects $object [dict merge [dict get $classes $class defaults] $values]
    return $object
  }

  proc exists {object} {
    variable objects
    return [dict exists $objects $object]
  }

  proc class_of {object} {
    return [lindex [split $object :] 0]
  }

  proc name_of {object} {
    return [join [lrange [split $object :] 1 end] :]
  }

  proc value {object property} {
    variable objects
    if {![dict exists $objects $object $property]} {
      fail "[class_of $object] [name_of $object] has no property $property"
    }
    return [dict get $objects $object $property]
  }

  proc set_value {object property value} {
    variable objects
    dict set objects $object $property $value
  }

  # All objects of a class whose names match; one that is asked for and is not there ends the run.
  proc find {class pattern {quiet 0}} {
    variable objects
    set found [dict keys $objects $class:$pattern]
    if {[llength $found] == 0 && !$quiet} {
      fail "there is no $class $pattern"
    }
    return $found
  }

  proc quiet {option} {
    return [dict exists $option -quiet]
  }

  command set_property {-dict:} {first second? third?} {
    if {[dict exists $option -dict]} {
      foreach object $first {
        dict for {property value} [dict get $option -dict] {
          write_property $object $property $value
        }
      }
    } else {
      if {[llength $third] == 0} {
        fail "set_property $first: no object"
      }
      foreach object $third {
        write_property $object $first $second
      }
    }
  }

  proc write_property {object property value} {
    variable classes
    if {![exists $object]} {
      fail "set_property $property: $object is no object"
    }
    set class [class_of $object]
    if {$property ni [dict get $classes $class writable] && ![cell_property $object $property]} {
      fail "set_property: a $class has no property $property"
    }
    set_value $object $property $value
    changed $object $property $value
  }

  # What else a property changes: each file of the stand-in adds its own.
  variable hooks {}
  proc on_change {class property body} {
    variable hooks
    dict set hooks $class,$property 1
    # tclint-disable-next-line command-args
    proc ::fake::changed_$class,$property {object value} $body
  }

  proc changed {object property value} {
    variable hooks
    set key [class_of $object],$property
    if {[dict exists $hooks $key]} {
      ::fake::changed_$key $object $value
    }
  }

  command get_property {} {property objects} {
    set values {}
    foreach object $objects {
      lappend values [value $object $property]
    }
    return [expr {[llength $values] == 1 ? [lindex $values 0] : $values}]
  }
}

# A command that is not of the stand-in: Tcl's own library, or an error that no script can catch.
proc unknown {args} {
  if {[auto_load [lindex $args 0]]} {
    return [uplevel 1 $args]
  }
  fake::fail "no command [lindex $args 0]"
}
