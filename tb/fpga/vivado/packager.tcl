# SPDX-License-Identifier: Apache-2.0
# The IP packager: a component from the project's top, its interfaces inferred as Vivado infers them.
namespace eval fake {
  class core {name {} version {} display_name {} description {}} {vendor {} library {} folder {} checked 0}
  class port {enablement_dependency {} driver_value {}} {direction {} width 1 info {} parameter {}}
  class interface {enablement_dependency {} slave_memory_map_ref {} master_address_space_ref {}} \
    {mode {} protocol {} width 0 vlnv {} ports {} clock {}}
  class space {range 0 width 0}
  class bus_parameter {value {}}
  class parameter {} {value {}}
  variable component ""

  # The signals of AXI: direction at the master, width (0: any), and whether AXI4-Lite must have it too.
  variable axi {
    awvalid {out 1 1} awready {in 1 1} awaddr {out 0 1} awid {out 0 0} awlen {out 8 0} awsize {out 3 0} awburst {out 2 0}
    awcache {out 4 0} awprot {out 3 0} wvalid {out 1 1} wready {in 1 1} wdata {out 0 1} wstrb {out 0 1} wlast {out 1 0}
    bvalid {in 1 1} bready {out 1 1} bid {in 0 0} bresp {in 2 1} arvalid {out 1 1} arready {in 1 1} araddr {out 0 1}
    arid {out 0 0} arlen {out 8 0} arsize {out 3 0} arburst {out 2 0} arcache {out 4 0} arprot {out 3 0} rvalid {in 1 1}
    rready {out 1 1} rdata {in 0 1} rid {in 0 0} rresp {in 2 1} rlast {in 1 0}
  }

  proc facts {} {
    set file [open $::env(CASTRAY_FACTS)]
    set lines [lsearch -all -inline -not -exact [split [read $file] "\n"] ""]
    close $file
    return $lines
  }

  # The synthesised ports are those of exactly the project's files.
  proc need_same_sources {} {
    variable root
    set wanted {}
    foreach fact [facts] {
      if {[lindex $fact 0] eq "source"} {
        lappend wanted [file join $root [lindex $fact 1]]
      }
    }
    set given {}
    foreach file [find file *] {
      lappend given [value $file path]
    }
    foreach {one other message} [list $wanted $given "does not hold" $given $wanted "holds, beyond the RTL,"] {
      foreach path $one {
        if {$path ni $other} {
          fail "ipx::package_project: the project $message $path"
        }
      }
    }
  }

  command ipx::package_project {-root_dir: -vendor: -library: -taxonomy:} {} {
    variable component
    set top [need_top]
    need_same_sources
    foreach fact [facts] {
      switch -- [lindex $fact 0] {
        parameter {create parameter [lindex $fact 1] [dict create value [lindex $fact 2]]}
        port {
          lassign $fact - name direction width info parameter
          create port $name [dict create direction [string range $direction 0 end-3] width $width info $info parameter $parameter]
        }
      }
    }
    infer_signals
    infer_axi
    infer_clocks
    set component [create core $top [dict create name $top vendor [dict get $option -vendor] \
      library [dict get $option -library] folder [dict get $option -root_dir]]]
    return $component
  }

  # Clock, reset and interrupt say what they are in an attribute.
  proc infer_signals {} {
    foreach port [find port *] {
      if {[regexp {^xilinx.com:signal:(clock|reset|interrupt):1.0 (\w+) \w+$} [value $port info] -> kind name]} {
        set mode [expr {[value $port direction] eq "in" ? "slave" : "master"}]
        create interface $name [dict create mode $mode protocol $kind width 1 ports [list [name_of $port]]]
        if {$kind eq "clock" && ![environment FAKE_BARE_PACKAGER 0]} {
          create bus_parameter $name/FREQ_HZ [dict create value 100000000]
        }
      } elseif {[value $port info] ne ""} {
        fail "[name_of $port]: X_INTERFACE_INFO '[value $port info]' is not known"
      }
    }
  }

  # The rest by their names: PREFIX_awvalid and so on.
  proc infer_axi {} {
    variable axi
    foreach valid [find port *_arvalid] {
      set prefix [string range [name_of $valid] 0 end-[string length _arvalid]]
      set mode [expr {[value $valid direction] eq "out" ? "master" : "slave"}]
      set full [exists port:${prefix}_arlen]
      set ports {}
      dict for {signal rule} $axi {
        lassign $rule direction width lite
        set port port:${prefix}_$signal
        if {![exists $port]} {
          if {$lite || $full} {
            fail "interface $prefix: there is no port [name_of $port]"
          }
          continue
        }
        if {([value $port direction] eq $direction) != ($mode eq "master")} {
          fail "port [name_of $port] has the wrong direction"
        }
        if {$width > 0 && [value $port width] != $width} {
          fail "port [name_of $port] has [value $port width] bits, AXI wants $width"
        }
        lappend ports [name_of $port]
      }
      set data [value port:${prefix}_rdata width]
      if {[value port:${prefix}_wdata width] != $data || 8 * [value port:${prefix}_wstrb width] != $data} {
        fail "interface $prefix: the widths of wdata, wstrb and rdata do not fit"
      }
      create interface $prefix [dict create mode $mode protocol [expr {$full ? "AXI4" : "AXI4LITE"}] width $data ports $ports]
      if {[environment FAKE_BARE_PACKAGER 0]} {
        continue
      }
      if {$mode eq "slave"} {
        create map $prefix
        create block $prefix/reg0
        set_value interface:$prefix slave_memory_map_ref $prefix
      } else {
        create space $prefix [dict create range [expr {1 << [value port:${prefix}_araddr width]}] width $data]
        set_value interface:$prefix master_address_space_ref $prefix
      }
    }
  }

  # Each AXI interface has a clock, which names it.
  proc infer_clocks {} {
    foreach port [find port *] {
      if {[regexp {ASSOCIATED_BUSIF ([\w:]+)} [value $port parameter] -> busses]} {
        foreach bus [split $busses :] {
          find interface $bus
          set_value interface:$bus clock [name_of $port]
        }
      }
    }
    foreach interface [find interface *] {
      if {[string match AXI* [value $interface protocol]] && [value $interface clock] eq ""} {
        fail "interface [name_of $interface] has no clock"
      }
    }
  }

  command ipx::current_core {} {} {
    variable component
    if {$component eq ""} {
      fail "ipx::current_core: nothing was packaged"
    }
    return $component
  }

  command ipx::get_ports {-quiet -of_objects:} {pattern} {
    return [find port $pattern [quiet $option]]
  }

  command ipx::get_bus_interfaces {-quiet -of_objects:} {pattern} {
    return [find interface $pattern [quiet $option]]
  }

  command ipx::get_bus_parameters {-quiet -of_objects:} {pattern} {
    return [find bus_parameter [name_of [dict get $option -of_objects]]/$pattern [quiet $option]]
  }

  command ipx::remove_bus_parameter {} {name interface} {
    variable objects
    find bus_parameter [name_of $interface]/$name
    dict unset objects bus_parameter:[name_of $interface]/$name
  }

  command ipx::get_address_spaces {-quiet -of_objects:} {pattern} {
    return [find space $pattern [quiet $option]]
  }

  command ipx::add_address_space {} {name core} {
    return [create space $name]
  }

  # Whether an expression of enablement holds for these parameters.
  proc enabled {expression parameters} {
    if {$expression eq ""} {
      return 1
    }
    if {![regexp {^spirit:decode\(id\('MODELPARAM_VALUE\.(\w+)'\)\) = (\d+)$} $expression -> name wanted]} {
      fail "enablement_dependency '$expression' is not understood"
    }
    if {![dict exists $parameters $name]} {
      fail "enablement_dependency: there is no parameter $name"
    }
    return [expr {[dict get $parameters $name] == $wanted}]
  }

  foreach class {port interface} {
    on_change $class enablement_dependency {
      enabled $value [parameter_values]
    }
  }

  proc parameter_values {} {
    set values {}
    foreach parameter [find parameter *] {
      dict set values [name_of $parameter] [value $parameter value]
    }
    return $values
  }

  command ipx::create_xgui_files {} {core} {}
  command ipx::update_checksums {} {core} {}

  command ipx::check_integrity {} {core} {
    foreach interface [find interface *] {
      if {![string match AXI* [value $interface protocol]]} {
        continue
      }
      foreach {mode reference class} {slave slave_memory_map_ref map master master_address_space_ref space} {
        if {[value $interface mode] eq $mode} {
          find $class [value $interface $reference]
        }
      }
    }
    check_registers
    set_value $core checked 1
  }

  # What a catalogue reads: component.xml, in the stand-in's own words.
  command ipx::save_core {} {core} {
    variable objects
    if {![value $core checked]} {
      fail "ipx::save_core: the integrity was not checked"
    }
    foreach property {name version} {
      if {[value $core $property] eq ""} {
        fail "ipx::save_core: the core has no $property"
      }
    }
    file mkdir [value $core folder]
    set file [open [file join [value $core folder] component.xml] w]
    puts $file [dict filter $objects script {object properties} {expr {[class_of $object] ni {project fileset file run}}}]
    close $file
  }
}
