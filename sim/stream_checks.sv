// SPDX-License-Identifier: Apache-2.0
// Binds the checker to the streams between the units of the core and to the AXI channels that it
// drives, where a simulation is built with assertions; synthesis never sees it. The streams into an
// arbiter and those out of a stream primitive have their checkers there.
bind castray_core stream_check #(.data_t(castray_pkg::tile_t)) u_check_tile (.clk_i, .rst_ni(datapath_rst_n), .valid_i(tile_valid), .ready_i(tile_ready), .data_i(tile));
bind ray_source stream_check #(.data_t(castray_pkg::pixel_tag_t)) u_check_px (.clk_i, .rst_ni, .valid_i(px_valid), .ready_i(px_ready), .data_i(px));
bind ray_source stream_check #(.data_t(castray_pkg::pixel_dir_t)) u_check_dir (.clk_i, .rst_ni, .valid_i(dir_valid), .ready_i(dir_ready), .data_i(dir));
bind castray_core stream_check #(.data_t(castray_pkg::ray_req_t)) u_check_list (.clk_i, .rst_ni(datapath_rst_n), .valid_i(list_valid), .ready_i(list_ready), .data_i(list_ray));
bind castray_core stream_check #(.data_t(castray_pkg::ray_t)) u_check_ray (.clk_i, .rst_ni(datapath_rst_n), .valid_i(ray_valid), .ready_i(ray_ready), .data_i(ray));
bind traversal stream_check #(.data_t(castray_pkg::prim_slot_t)) u_check_slot (.clk_i, .rst_ni, .valid_i(slot_valid), .ready_i(slot_ready), .data_i(slot));
bind shading stream_check #(.data_t(castray_image_pkg::shade_req_t)) u_check_shade (.clk_i, .rst_ni, .valid_i(attr_valid), .ready_i(attr_ready), .data_i(shade_req));
bind axi_reader stream_check #(.data_t(logic [51:0])) u_check_ar (.clk_i, .rst_ni, .valid_i(m_axi_arvalid_o), .ready_i(m_axi_arready_i), .data_i({m_axi_arid_o, m_axi_arlen_o, m_axi_araddr_o}));
bind axi_writer stream_check #(.data_t(logic [51:0])) u_check_aw (.clk_i, .rst_ni, .valid_i(m_axi_awvalid_o), .ready_i(m_axi_awready_i), .data_i({m_axi_awid_o, m_axi_awlen_o, m_axi_awaddr_o}));
bind axi_writer stream_check #(.data_t(logic [144:0])) u_check_w (.clk_i, .rst_ni, .valid_i(m_axi_wvalid_o), .ready_i(m_axi_wready_i), .data_i({m_axi_wlast_o, m_axi_wstrb_o, m_axi_wdata_o}));
bind castray_core stream_check #(.data_t(logic [1:0])) u_check_lite_b (.clk_i, .rst_ni, .valid_i(s_axi_bvalid_o), .ready_i(s_axi_bready_i), .data_i(s_axi_bresp_o));
bind castray_core stream_check #(.data_t(logic [33:0])) u_check_lite_r (.clk_i, .rst_ni, .valid_i(s_axi_rvalid_o), .ready_i(s_axi_rready_i), .data_i({s_axi_rresp_o, s_axi_rdata_o}));
