// SPDX-License-Identifier: Apache-2.0
// The nearest hit of each context. A result replaces what is held if its distance is smaller, or
// equal with a lower primitive number: the outcome does not depend on the order of the results.
// A new ray starts with its tmax and number 0, so a hit at exactly tmax is none. Until a hit is found
// u and v read as 0: the memories still hold those of the ray before.
// One new ray or one result a cycle (never both); reads are combinational. reach: what lies beyond
// it, in units of a dist_t, is behind the nearest hit.
// Model: cpp_model/traverse/nearest.hpp, equal bit for bit.
module nearest
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Contexts = DefaultContexts,
  localparam int unsigned IdxW = (Contexts > 1) ? $clog2(Contexts) : 1
) (
  input  logic            clk_i,

  input  logic            start_i,        // a new ray in start_ctx_i
  input  logic [IdxW-1:0] start_ctx_i,
  input  t_t              tmax_i,

  input  logic            result_valid_i,
  input  result_t         result_i,

  input  logic [IdxW-1:0] node_ctx_i,     // for the node pipe
  output t_t              node_t_o,

  input  logic [IdxW-1:0] step_ctx_i [2], // for the next steps
  output dist_t           step_reach_o [2],
  output logic [1:0]      step_found_o,

  input  logic [IdxW-1:0] out_ctx_i,      // for the lane's output
  output logic            out_found_o,
  output result_t         out_o
);
  typedef struct packed {
    logic  found;
    logic  kind;
    prim_t number;
    t_t    t;
  } key_t;

  key_t  key_q [Contexts];
  bary_t u_q   [Contexts];
  bary_t v_q   [Contexts];

  logic [IdxW-1:0] at;
  key_t            held;
  logic signed [CoordW+TFrac:0] t_held, t_new;
  logic            write;

  assign at = start_i ? start_ctx_i : IdxW'(result_i.ctx);
  always_comb begin
    held   = '0;
    t_held = '0;
    t_new  = '0;
    write  = 1'b0;
    if (result_valid_i && !start_i) begin
      held   = key_q[at];
      t_held = held.t;
      t_new  = result_i.t;
      write  = t_new < t_held || (t_new == t_held && result_i.number < held.number);
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      key_q[at] <= '{found: 1'b0, kind: KindTriangle, number: '0, t: tmax_i};
    end else if (write) begin
      key_q[at] <= '{found: 1'b1, kind: result_i.kind, number: result_i.number, t: result_i.t};
      u_q[at]   <= result_i.u;
      v_q[at]   <= result_i.v;
    end
  end

  // The upper bits of a distance, zero for a negative one.
  function automatic dist_t reach(t_t t);
    return t[CoordW+TFrac] ? '0 : t[CoordW+TFrac-1 -: DistW];
  endfunction

  key_t node_key;
  assign node_key     = key_q[node_ctx_i];
  assign node_t_o     = node_key.t;
  for (genvar i = 0; i < 2; i++) begin : g_step
    key_t step_key;
    assign step_key        = key_q[step_ctx_i[i]];
    assign step_reach_o[i] = reach(step_key.t);
    assign step_found_o[i] = step_key.found;
  end

  key_t out_key;
  assign out_key     = key_q[out_ctx_i];
  assign out_found_o = out_key.found;
  assign out_o = '{
    ctx: CtxW'(out_ctx_i), number: out_key.number, kind: out_key.kind, t: out_key.t,
    u: out_key.found ? u_q[out_ctx_i] : '0, v: out_key.found ? v_q[out_ctx_i] : '0
  };
endmodule
