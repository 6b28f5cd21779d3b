// SPDX-License-Identifier: Apache-2.0
// The nearest hit of each context. A result replaces what is held if its distance is smaller, or
// equal with a lower primitive number: the outcome does not depend on the order of the results.
// A new ray starts with its tmax and number 0, so a hit at exactly tmax is none. Until a hit is found
// u and v read as 0: the memories still hold those of the ray before.
// One new ray or one result a cycle (never both); reads are combinational. A result's u and v can be read
// two cycles after it, all else one: no ray leaves a lane sooner.
// reach: what lies beyond it, in units of a dist_t, is behind the nearest hit.
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
  // What the next steps read is a memory of its own.
  localparam int unsigned LowW = $bits(t_t) - 1 - DistW;
  typedef struct packed {
    logic           found;
    logic [DistW:0] t_high;
  } reach_t;
  typedef struct packed {
    logic            kind;
    prim_t           number;
    logic [LowW-1:0] t_low;
  } rest_t;
  typedef logic [$bits(t_t)+PrimW-1:0] order_t;   // a distance, its sign turned, then a number

  reach_t reach_q [Contexts];
  rest_t  rest_q  [Contexts];
  bary_t  u_q     [Contexts];
  bary_t  v_q     [Contexts];

  logic [IdxW-1:0] result_ctx, at;
  order_t          held, fresh;
  t_t              t_new;
  logic            write;

  function automatic order_t turned(order_t x);
    return x ^ {1'b1, {$bits(order_t)-1{1'b0}}};
  endfunction

  assign t_new      = result_valid_i ? result_i.t : tmax_i;
  assign result_ctx = IdxW'(result_i.ctx);
  assign at         = result_valid_i ? result_ctx : start_ctx_i;
  always_comb begin
    held  = turned({reach_q[result_ctx].t_high, rest_q[result_ctx].t_low, rest_q[result_ctx].number});
    fresh = turned({result_i.t, result_i.number});
    write = result_valid_i && fresh < held;
  end

  // u and v are written a cycle later.
  logic            write_q;
  logic [IdxW-1:0] write_at_q;
  bary_t           write_u_q, write_v_q;
  always_ff @(posedge clk_i) begin
    write_q <= write;
    if (result_valid_i) begin
      write_at_q <= result_ctx;
      write_u_q  <= result_i.u;
      write_v_q  <= result_i.v;
    end
    if (write_q) begin
      u_q[write_at_q] <= write_u_q;
      v_q[write_at_q] <= write_v_q;
    end
  end
  always_ff @(posedge clk_i) begin
    if (start_i || write) begin
      reach_q[at] <= '{found: result_valid_i, t_high: t_new[LowW +: DistW+1]};
      rest_q[at]  <= '{kind: result_valid_i ? result_i.kind : KindTriangle, number: result_valid_i ? result_i.number : '0,
                       t_low: t_new[LowW-1:0]};
    end
  end

  // The upper bits of a distance, zero for a negative one.
  function automatic dist_t reach(logic [DistW:0] t_high);
    return t_high[DistW] ? '0 : t_high[DistW-1:0];
  endfunction

  assign node_t_o = {reach_q[node_ctx_i].t_high, rest_q[node_ctx_i].t_low};
  for (genvar i = 0; i < 2; i++) begin : g_step
    reach_t step_reach;
    assign step_reach      = reach_q[step_ctx_i[i]];
    assign step_reach_o[i] = reach(step_reach.t_high);
    assign step_found_o[i] = step_reach.found;
  end

  reach_t out_reach;
  rest_t  out_rest;
  assign out_reach   = reach_q[out_ctx_i];
  assign out_rest    = rest_q[out_ctx_i];
  assign out_found_o = out_reach.found;
  assign out_o = '{
    ctx: CtxW'(out_ctx_i), number: out_rest.number, kind: out_rest.kind, t: {out_reach.t_high, out_rest.t_low},
    u: out_reach.found ? u_q[out_ctx_i] : '0, v: out_reach.found ? v_q[out_ctx_i] : '0
  };
endmodule
