// SPDX-License-Identifier: Apache-2.0
// The register map: byte offsets on the AXI4-Lite port. The first four, the order of pointers and
// the meaning of bits follow what HLS tools generate, so that their users find what they know.
// docs/register-map.md is the reader's version and is checked against this file.
package castray_reg_pkg;
  localparam int unsigned RegAddrW = 9;

  localparam int unsigned RegControl    = 'h000;  // ap_ctrl, see the Ctrl bits
  localparam int unsigned RegGie        = 'h004;  // bit 0: interrupts reach the pin
  localparam int unsigned RegIer        = 'h008;  // which of the Isr bits may raise it
  localparam int unsigned RegIsr        = 'h00c;  // toggled by writing ones
  localparam int unsigned RegImage      = 'h010;  // scene image, 64-bit pointer, 256-byte aligned
  localparam int unsigned RegFrame      = 'h01c;  // frame buffer, 64-bit pointer, 64-byte aligned
  localparam int unsigned RegHits       = 'h028;  // hit buffer, 64-bit pointer, 64-byte aligned
  localparam int unsigned RegImageBytes = 'h034;  // size of each of the three windows, bytes
  localparam int unsigned RegFrameBytes = 'h03c;
  localparam int unsigned RegHitsBytes  = 'h044;
  localparam int unsigned RegFrameSize  = 'h04c;  // width | height << 16, 1 to MaxFrameSize each
  localparam int unsigned RegOptions    = 'h054;  // see the Option bits
  localparam int unsigned RegWindowMin  = 'h05c;  // x0 | y0 << 16: the first pixel rendered
  localparam int unsigned RegWindowMax  = 'h064;  // x1 | y1 << 16: one past the last; 0: the frame

  localparam int unsigned RegSteps      = 'h06c;  // nodes that a ray may visit, below 2^24; 0: no limit but that

  // Read only.
  localparam int unsigned RegVersion    = 'h080;  // major << 16 | minor << 8 | patch
  localparam int unsigned RegConfig     = 'h084;  // lanes | contexts << 8 | tile size << 16
  localparam int unsigned RegParameters = 'h088;  // ImageParameters of this build
  localparam int unsigned RegError      = 'h08c;  // error_t of the last job

  // Of a list of rays.
  localparam int unsigned RegRays       = 'h090;  // its records, 64-bit pointer, 64-byte aligned
  localparam int unsigned RegRayBytes   = 'h09c;  // size of their window, bytes
  localparam int unsigned RegRayCount   = 'h0a4;  // 1 to MaxRays

  // Counters of the last job, 64 bits each, low word first.
  localparam int unsigned RegCounters     = 'h100;
  localparam int unsigned CntCycles       = 0;   // accepted start to done
  localparam int unsigned CntTests        = 1;   // ray/primitive tests
  localparam int unsigned CntRays         = 2;   // rays that entered a lane
  localparam int unsigned CntHits         = 3;   // rays that hit
  localparam int unsigned CntCandidates   = 4;   // tests accepted by the exact test
  localparam int unsigned CntBatches      = 5;   // passes over the primitive buffer
  localparam int unsigned CntTestStalls   = 6;   // cycles in which a test waited for a lane
  localparam int unsigned CntFetchStalls  = 7;   // cycles in which a test waited for a primitive
  localparam int unsigned CntAttrHits     = 8;   // attribute cache
  localparam int unsigned CntAttrMisses   = 9;
  localparam int unsigned CntReadBeats    = 10;
  localparam int unsigned CntWriteBeats   = 11;
  localparam int unsigned CntNodes        = 12;  // ray/node tests, those of tiles' frontiers too
  localparam int unsigned CntNodeHits     = 13;  // node caches of the lanes
  localparam int unsigned CntNodeMisses   = 14;
  localparam int unsigned CntLeafHits     = 15;  // leaf caches of the lanes
  localparam int unsigned CntLeafMisses   = 16;
  localparam int unsigned CntNodeWaits    = 17;  // cycles, over the lanes, in which a ray waited to look up a node
  localparam int unsigned CntLeafWaits    = 18;  // or a leaf
  localparam int unsigned CntTestWaits    = 19;  // or a test for the hit unit's queue
  localparam int unsigned CntL2Hits       = 20;  // the shared cache
  localparam int unsigned CntL2Misses     = 21;
  localparam int unsigned CntTileNodes    = 22;  // nodes read to start tiles
  localparam int unsigned CntTileHits     = 23;  // their cache
  localparam int unsigned CntTileMisses   = 24;
  localparam int unsigned CntEmptyTiles   = 25;  // tiles filled with background
  localparam int unsigned CntHitUnitBusy  = 26;  // cycles with a test at the hit unit's entrance
  localparam int unsigned CntShaderBusy   = 27;  // in which the shader normalised a vector
  localparam int unsigned CntTileBusy     = 28;  // in which a node was split to start a tile
  localparam int unsigned CntStarved      = 29;  // cycles, over the lanes, in which one had room for a ray and none came
  localparam int unsigned CntHitWaits     = 30;  // or a hit waited to leave
  localparam int unsigned CntWriteWaits   = 31;  // cycles, over pixels and records, in which a burst waited for the port
  localparam int unsigned Counters        = 32;  // as many as the addresses have room for
  localparam int unsigned EventBits       = 8;   // events of one counter in a cycle: one a lane

  // Bits of RegControl.
  localparam int unsigned CtrlStart       = 0;
  localparam int unsigned CtrlDone        = 1;   // cleared by reading
  localparam int unsigned CtrlIdle        = 2;
  localparam int unsigned CtrlReady       = 3;   // cleared by reading
  localparam int unsigned CtrlAutoRestart = 7;
  localparam int unsigned CtrlInterrupt   = 9;   // level of the interrupt pin
  // Bits of RegIer and RegIsr.
  localparam int unsigned IsrDone  = 0;
  localparam int unsigned IsrReady = 1;
  // Bits of RegOptions.
  localparam int unsigned OptionHits   = 0;      // write the hit buffer
  localparam int unsigned OptionZOrder = 1;      // walk the tiles along a Z curve
  localparam int unsigned OptionBrute  = 2;      // every ray against every primitive, without the hierarchy
  localparam int unsigned OptionRoot   = 3;      // every ray starts at the root, without tile_start
  localparam int unsigned OptionWork   = 4;      // the hit records hold the nodes and tests of each ray
  localparam int unsigned OptionList   = 5;      // a list of rays, no frame
  localparam int unsigned NumOptions   = 6;      // from bit 0 up
endpackage
