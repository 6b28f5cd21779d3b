// The one list of RTL files, in compilation order: lint, simulation and synthesis all read it.
rtl/pkg/castray_cfg_pkg.sv
rtl/pkg/castray_pkg.sv
rtl/pkg/castray_image_pkg.sv
rtl/pkg/castray_reg_pkg.sv
rtl/prim/pipe_stage.sv
rtl/prim/pipe_cut.sv
rtl/prim/stream_fifo.sv
rtl/prim/stream_arb.sv
rtl/prim/credit.sv
rtl/prim/stream_fork.sv
rtl/traverse/ray_dispatch.sv
rtl/traverse/brute_walk.sv
rtl/traverse/ray_store.sv
rtl/traverse/nearest.sv
