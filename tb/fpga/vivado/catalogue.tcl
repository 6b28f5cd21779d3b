# SPDX-License-Identifier: Apache-2.0
# The IPs that a block design may hold: three of Vivado's own, and what lies in the repositories of the project.
#
# ip_description gives, for a cell's parameters: pins {NAME {direction width kind}} and interfaces
# {NAME {mode protocol width clock}}, kind being clock, reset or data; and what addresses it has:
# spaces {NAME {interface ...}} and segments {NAME {interface range}}.
namespace eval fake {
  variable own {
    xilinx.com:ip:zynq_ultra_ps_e:3.5 {
      PSU__FPGA_PL0_ENABLE 1 PSU__CRL_APB__PL0_REF_CTRL__FREQMHZ 100
      PSU__USE__M_AXI_GP0 1 PSU__USE__M_AXI_GP1 1 PSU__USE__M_AXI_GP2 0
      PSU__MAXIGP0__DATA_WIDTH 128 PSU__MAXIGP1__DATA_WIDTH 128 PSU__MAXIGP2__DATA_WIDTH 32
      PSU__USE__S_AXI_GP2 0 PSU__USE__S_AXI_GP3 0 PSU__USE__S_AXI_GP4 0 PSU__USE__S_AXI_GP5 0
      PSU__SAXIGP2__DATA_WIDTH 128 PSU__SAXIGP3__DATA_WIDTH 128 PSU__SAXIGP4__DATA_WIDTH 128 PSU__SAXIGP5__DATA_WIDTH 128
      PSU__USE__IRQ0 0
    }
    xilinx.com:ip:smartconnect:1.0 {NUM_SI 1 NUM_MI 1}
    xilinx.com:ip:proc_sys_reset:5.0 {}
  }
  class ip {} {VLNV {}}
  variable packaged {}

  command update_ip_catalog {} {} {
    variable own
    variable packaged
    foreach vlnv [dict keys $own] {
      if {![exists ip:$vlnv]} {
        create ip $vlnv [dict create VLNV $vlnv]
      }
    }
    foreach folder [value [open_project] ip_repo_paths] {
      need_file [file join $folder component.xml]
      set file [open [file join $folder component.xml]]
      set component [read $file]
      close $file
      set core [dict get $component [lindex [dict keys $component core:*] 0]]
      set vlnv [join [list [dict get $core vendor] [dict get $core library] [dict get $core name] [dict get $core version]] :]
      dict set packaged $vlnv $component
      create ip $vlnv [dict create VLNV $vlnv]
    }
  }

  command get_ipdefs {-all} {pattern} {
    return [find ip $pattern]
  }

  # The parameters of an IP with their defaults.
  proc ip_parameters {vlnv} {
    variable own
    variable packaged
    if {[dict exists $own $vlnv]} {
      return [dict get $own $vlnv]
    }
    set parameters {}
    dict for {object properties} [dict filter [dict get $packaged $vlnv] key parameter:*] {
      dict set parameters [name_of $object] [dict get $properties value]
    }
    return $parameters
  }

  proc ip_description {vlnv parameters} {
    variable own
    if {[dict exists $own $vlnv]} {
      return [describe_[lindex [split $vlnv :] 2] $parameters]
    }
    return [describe_packaged $vlnv $parameters]
  }

  proc describe_zynq_ultra_ps_e {parameters} {
    dict with parameters {}
    set pins {pl_resetn0 {out 1 reset}}
    set interfaces {}
    set segments {}
    if {$PSU__FPGA_PL0_ENABLE} {
      dict set pins pl_clk0 {out 1 clock}
    }
    if {$PSU__USE__IRQ0} {
      dict set pins pl_ps_irq0 {in 1 interrupt}
    }
    foreach {group port} {0 HPM0_FPD 1 HPM1_FPD 2 HPM0_LPD} {
      if {[set PSU__USE__M_AXI_GP$group]} {
        set clock maxi[string tolower $port]_aclk
        dict set pins $clock {in 1 clock}
        dict set interfaces M_AXI_$port [list master AXI4 [set PSU__MAXIGP${group}__DATA_WIDTH] $clock]
      }
    }
    foreach {group port} {2 HP0 3 HP1 4 HP2 5 HP3} {
      if {[set PSU__USE__S_AXI_GP$group]} {
        set clock saxi[string tolower $port]_fpd_aclk
        dict set pins $clock {in 1 clock}
        dict set interfaces S_AXI_${port}_FPD [list slave AXI4 [set PSU__SAXIGP${group}__DATA_WIDTH] $clock]
        foreach {segment range} {DDR_LOW 0x80000000 QSPI 0x20000000 LPS_OCM 0x1000000} {
          dict set segments SAXIGP$group/${port}_$segment [list S_AXI_${port}_FPD $range]
        }
      }
    }
    return [dict create pins $pins interfaces $interfaces segments $segments spaces {Data {M_AXI_HPM0_FPD}}]
  }

  # Any width and protocol at its ends: it converts.
  proc describe_smartconnect {parameters} {
    set interfaces {}
    for {set i 0} {$i < [dict get $parameters NUM_SI]} {incr i} {
      dict set interfaces [format S%02d_AXI $i] {slave any any aclk}
    }
    for {set i 0} {$i < [dict get $parameters NUM_MI]} {incr i} {
      dict set interfaces [format M%02d_AXI $i] {master any any aclk}
    }
    return [dict create pins {aclk {in 1 clock} aresetn {in 1 reset}} interfaces $interfaces segments {} spaces {}]
  }

  proc describe_proc_sys_reset {parameters} {
    set pins {
      slowest_sync_clk {in 1 clock} ext_reset_in {in 1 reset} aux_reset_in {in 1 optional} dcm_locked {in 1 optional}
      peripheral_aresetn {out 1 reset} interconnect_aresetn {out 1 reset} peripheral_reset {out 1 data}
    }
    return [dict create pins $pins interfaces {} segments {} spaces {}]
  }

  proc describe_packaged {vlnv parameters} {
    variable packaged
    set component [dict get $packaged $vlnv]
    set pins {}
    set interfaces {}
    set spaces {}
    set segments {}
    dict for {object interface} [dict filter $component key interface:*] {
      dict with interface {}
      if {![enabled $enablement_dependency $parameters]} {
        continue
      }
      if {$protocol in {clock reset interrupt}} {
        dict set pins [lindex $ports 0] [list [expr {$mode eq "slave" ? "in" : "out"}] 1 $protocol]
        continue
      }
      set name [name_of $object]
      dict set interfaces $name [list $mode $protocol $width $clock]
      if {$mode eq "master"} {
        dict set spaces $master_address_space_ref [list $name]
        continue
      }
      dict for {block properties} [dict filter $component key block:$slave_memory_map_ref/*] {
        dict set segments [name_of $block] [list $name [dict get $properties range]]
      }
    }
    return [dict create pins $pins interfaces $interfaces segments $segments spaces $spaces]
  }
}
