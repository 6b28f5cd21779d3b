# SPDX-License-Identifier: Apache-2.0
# The block design: processor, core, clock and reset, control, memory, interrupt.
#
#   ps/M_AXI_HPM0_FPD --> control (SmartConnect) --> castray/s_axi        0xA0000000, 4 KB
#   castray/m_axi_0 ----> ps/S_AXI_HP1_FPD                                the lower 2 GB of DDR
#   castray/m_axi_1 ----> ps/S_AXI_HP2_FPD                                the same, with two ports
#   castray/interrupt --> ps/pl_ps_irq0
#
# HP1 and HP2, because HP0 shares its way to the DDR with the display. A memory port needs no interconnect: both ends are AXI4 of
# 128 bits, of one clock, and the core's bursts are short enough (docs/memory.md).

# An IP of Vivado's own, in the version that this Vivado has.
proc add_cell {ip name} {
  return [create_bd_cell -type ip -vlnv [get_property VLNV [get_ipdefs "xilinx.com:ip:$ip:*"]] $name]
}

proc add_processor {clock_mhz ports} {
  set ps [add_cell zynq_ultra_ps_e ps]
  apply_bd_automation -rule xilinx.com:bd_rule:zynq_ultra_ps_e -config {apply_board_preset 1} $ps
  set_property -dict [list \
    CONFIG.PSU__FPGA_PL0_ENABLE 1 \
    CONFIG.PSU__CRL_APB__PL0_REF_CTRL__FREQMHZ $clock_mhz \
    CONFIG.PSU__USE__M_AXI_GP0 1 \
    CONFIG.PSU__MAXIGP0__DATA_WIDTH 32 \
    CONFIG.PSU__USE__M_AXI_GP1 0 \
    CONFIG.PSU__USE__M_AXI_GP2 0 \
    CONFIG.PSU__USE__S_AXI_GP3 1 \
    CONFIG.PSU__SAXIGP3__DATA_WIDTH 128 \
    CONFIG.PSU__USE__IRQ0 1 \
  ] $ps
  if {$ports == 2} {
    set_property -dict [list CONFIG.PSU__USE__S_AXI_GP4 1 CONFIG.PSU__SAXIGP4__DATA_WIDTH 128] $ps
  }
}

# A clock of the processor and its reset for all.
proc connect_clock {ports} {
  add_cell proc_sys_reset reset
  set clocked {ps/maxihpm0_fpd_aclk ps/saxihp1_fpd_aclk reset/slowest_sync_clk control/aclk castray/aclk}
  if {$ports == 2} {
    lappend clocked ps/saxihp2_fpd_aclk
  }
  foreach pin $clocked {
    connect_bd_net [get_bd_pins ps/pl_clk0] [get_bd_pins $pin]
  }
  connect_bd_net [get_bd_pins ps/pl_resetn0] [get_bd_pins reset/ext_reset_in]
  foreach pin {control/aresetn castray/aresetn} {
    connect_bd_net [get_bd_pins reset/peripheral_aresetn] [get_bd_pins $pin]
  }
}

proc connect_interfaces {from to} {
  connect_bd_intf_net [get_bd_intf_pins $from] [get_bd_intf_pins $to]
}

# One memory port: what it reaches is the DDR alone; the flash, the processor's own memory and what else there is are left out.
proc connect_memory {master group port} {
  connect_interfaces castray/$master ps/S_AXI_${port}_FPD
  set space [get_bd_addr_spaces castray/$master]
  foreach segment [get_bd_addr_segs ps/$group/*] {
    if {[string match "*/${port}_DDR_LOW" $segment]} {
      assign_bd_address -offset 0x00000000 -range 2G -target_address_space $space $segment
    } else {
      exclude_bd_addr_seg -target_address_space $space $segment
    }
  }
}

proc block_design {name vlnv settings} {
  dict with settings {}
  create_bd_design $name
  add_processor $clock_mhz $ports
  set core [create_bd_cell -type ip -vlnv $vlnv castray]
  set_property -dict [list CONFIG.Lanes $lanes CONFIG.Contexts $contexts CONFIG.TileLog2 $tile_log2 \
    CONFIG.Ports $ports CONFIG.L2Kbytes $l2_kbytes] $core
  set control [add_cell smartconnect control]
  set_property -dict [list CONFIG.NUM_SI 1 CONFIG.NUM_MI 1] $control
  connect_clock $ports

  connect_interfaces ps/M_AXI_HPM0_FPD control/S00_AXI
  connect_interfaces control/M00_AXI castray/s_axi
  assign_bd_address -offset 0xA0000000 -range 4K -target_address_space [get_bd_addr_spaces ps/Data] \
    [get_bd_addr_segs castray/s_axi/*]
  connect_memory m_axi_0 SAXIGP3 HP1
  if {$ports == 2} {
    connect_memory m_axi_1 SAXIGP4 HP2
  }
  connect_bd_net [get_bd_pins castray/interrupt] [get_bd_pins ps/pl_ps_irq0]

  validate_bd_design
  save_bd_design
}
