// SPDX-License-Identifier: Apache-2.0
// The lanes' events by kind: of each kind one bit a lane, for the counters. Wires only.
module lane_sums
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_reg_pkg::*;
#(
  parameter int unsigned Lanes = DefaultLanes
) (
  input  lane_events_t events_i [Lanes],
  output lane_sums_t   sums_o
);
  always_comb begin
    sums_o = '0;
    for (int unsigned i = 0; i < Lanes; i++) begin
      sums_o.node[i]      = events_i[i].node;
      sums_o.test[i]      = events_i[i].test;
      sums_o.cand[i]      = events_i[i].cand;
      sums_o.node_hit[i]  = events_i[i].node_hit;
      sums_o.node_miss[i] = events_i[i].node_miss;
      sums_o.leaf_hit[i]  = events_i[i].leaf_hit;
      sums_o.leaf_miss[i] = events_i[i].leaf_miss;
      sums_o.node_wait[i] = events_i[i].node_wait;
      sums_o.leaf_wait[i] = events_i[i].leaf_wait;
      sums_o.test_wait[i] = events_i[i].test_wait;
    end
  end
endmodule
