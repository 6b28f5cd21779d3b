// The one list of RTL files, in compilation order: lint, simulation and synthesis all read it.
rtl/pkg/castray_cfg_pkg.sv
rtl/pkg/castray_pkg.sv
rtl/pkg/castray_image_pkg.sv
rtl/pkg/castray_reg_pkg.sv
rtl/prim/pipe_stage.sv
rtl/prim/pipe_cut.sv
rtl/prim/stream_fifo.sv
rtl/prim/stream_arb.sv
