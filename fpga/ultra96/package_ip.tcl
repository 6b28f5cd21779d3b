# SPDX-License-Identifier: Apache-2.0
# Packages the core as an IP: castray_top with its interfaces, parameters and registers. The IP refers to the sources where
# they are; nothing is copied.

# The RTL as lint and simulation read it, and the wrapper.
proc castray_sources {root} {
  set list [open [file join $root rtl castray.f]]
  set sources {}
  foreach line [split [read $list] "\n"] {
    if {$line ne "" && ![string match "//*" $line]} {
      lappend sources [file join $root $line]
    }
  }
  close $list
  return [lappend sources [file join $root fpga ultra96 castray_top.v]]
}

# Vendor, library, name and version.
proc castray_vlnv {root} {
  set file [open [file join $root fpga ultra96 vlnv.txt]]
  set vlnv [string trim [read $file]]
  close $file
  return $vlnv
}

# The only address block of the control interface; the packager may have made it.
proc control_block {core} {
  set map [ipx::get_memory_maps -quiet s_axi -of_objects $core]
  if {$map eq ""} {
    set map [ipx::add_memory_map s_axi $core]
    set_property slave_memory_map_ref s_axi [ipx::get_bus_interfaces s_axi -of_objects $core]
  }
  set blocks [ipx::get_address_blocks -quiet * -of_objects $map]
  if {[llength $blocks] == 0} {
    set blocks [ipx::add_address_block registers $map]
  }
  return [lindex $blocks 0]
}

# The registers by name, which PYNQ's register_map shows. The list is derived from rtl/pkg/castray_reg_pkg.sv.
proc add_registers {core registers} {
  set block [control_block $core]
  set_property usage register $block
  set_property range 4096 $block
  set_property width 32 $block
  foreach register $registers {
    lassign $register name offset access meaning fields
    set added [ipx::add_register $name $block]
    set_property address_offset $offset $added
    set_property size 32 $added
    set_property access $access $added
    set_property description $meaning $added
    foreach field $fields {
      lassign $field field_name bit field_meaning
      set added_field [ipx::add_field $field_name $added]
      set_property bit_offset $bit $added_field
      set_property bit_width 1 $added_field
      set_property access $access $added_field
      set_property description $field_meaning $added_field
    }
  }
}

# With one port there is no second memory interface.
proc hide_second_port {core} {
  set two "spirit:decode(id('MODELPARAM_VALUE.Ports')) = 2"
  set_property enablement_dependency $two [ipx::get_bus_interfaces m_axi_1 -of_objects $core]
  foreach port [ipx::get_ports m_axi_1_* -of_objects $core] {
    set_property -dict [list driver_value 0 enablement_dependency $two] $port
  }
}

# The masters' address spaces; the packager may have made them.
proc add_address_spaces {core} {
  foreach name {m_axi_0 m_axi_1} {
    if {[ipx::get_address_spaces -quiet $name -of_objects $core] eq ""} {
      set space [ipx::add_address_space $name $core]
      set_property range [expr {1 << 40}] $space
      set_property width 128 $space
      set_property master_address_space_ref $name [ipx::get_bus_interfaces $name -of_objects $core]
    }
  }
}

# The clock's frequency is the design's, not the package's: one that the packager noted down would be compared with the
# processor's, which is only nearly what was asked for.
proc leave_frequency_open {core} {
  set clock [ipx::get_bus_interfaces aclk -of_objects $core]
  if {[llength [ipx::get_bus_parameters -quiet FREQ_HZ -of_objects $clock]] > 0} {
    ipx::remove_bus_parameter FREQ_HZ $clock
  }
}

proc package_ip {root folder part registers} {
  create_project -force castray_ip [file join $folder project] -part $part
  add_files -norecurse [castray_sources $root]
  set_property top castray_top [current_fileset]
  update_compile_order -fileset sources_1

  lassign [split [castray_vlnv $root] :] vendor library name version
  ipx::package_project -root_dir [file join $folder ip] -vendor $vendor -library $library -taxonomy /castray
  set core [ipx::current_core]
  set_property name $name $core
  set_property version $version $core
  set_property display_name castray $core
  set_property description "Ray-tracing core: triangles and spheres, a hierarchy, 1 to 8 lanes" $core

  add_registers $core $registers
  add_address_spaces $core
  hide_second_port $core
  leave_frequency_open $core

  ipx::create_xgui_files $core
  ipx::update_checksums $core
  ipx::check_integrity $core
  ipx::save_core $core
  close_project
}
