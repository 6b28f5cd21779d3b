// SPDX-License-Identifier: Apache-2.0
// Bit widths of the arithmetic: the one place where each is chosen.
// docs/number-formats.md derives them and says under *Other widths* what else they may be;
// math/width_check refuses the rest at elaboration.
package castray_cfg_pkg;
  // Version of the core, major.minor.patch; the version register and `castray --version` show it.
  localparam int unsigned VersionMajor = 0;
  localparam int unsigned VersionMinor = 1;
  localparam int unsigned VersionPatch = 0;

  // A position: unsigned steps of the scene's grid from the scene's corner. 20 to 26.
  localparam int unsigned CoordW = 26;
  // Bits of a position's field in a record: fixed, so that CoordW does not move the scene image.
  localparam int unsigned CoordFieldW = 26;
  // Fraction bits of the shear Sx, Sy of a ray. 16 to 26.
  localparam int unsigned ShearFrac = 26;
  // Fraction bits of a distance along the dominant axis. 2 to 4: roots come in quarter steps.
  localparam int unsigned TFrac = 4;
  // Fraction bits of u and v, the quotients of the hit divider. 12 to 24.
  localparam int unsigned BaryFrac = 24;
  // Operand bits of the hit divider, after normalisation. BaryFrac + 2 to 26.
  localparam int unsigned HitDivW = 26;
  // Operand bits of the shear divider, after normalisation. ShearFrac + 2 to DirFrac + 3.
  localparam int unsigned ShearDivW = 32;
  // Fraction bits of a ray's direction before the division. Fixed.
  localparam int unsigned DirFrac = 42;
  // Bits of the mantissa of 1 / |S|, its top one included. Fixed: with D's 27 bits a DSP is full.
  localparam int unsigned RecipW = 17;
  // Bits of a distance kept with a child that waits. Fixed: three such children fill a stack's frame.
  localparam int unsigned DistW = 12;
  // Fraction bits of it while it is computed. Fixed.
  localparam int unsigned DistFrac = 2;
  // A tick is this power of two below the spacing of a node's planes across the dominant axis. 2 to 6.
  localparam int unsigned SubPlane = 3;
  // Steps by which a hit may lie before or behind its box along the ray, and what a t loses when it is cut to
  // whole steps: docs/number-formats.md, "The margin of a box".
  localparam int unsigned BoxMargin = (((1 << (CoordW + 1)) - 1) >> BaryFrac) + 2;
  // Fraction bits of 1 + Sx^2 + Sy^2: without its top bit it is a shear of as many bits as another.
  localparam int unsigned NormFrac = ShearFrac - 2;
  // Fraction bits of a unit normal, a weight and a facing ratio. Fixed.
  localparam int unsigned UnitFrac = 16;
  // Integer bits, with the sign, of a texture coordinate, which has UnitFrac fraction bits. Fixed.
  localparam int unsigned TexInt = 11;
  // Bits of the normaliser's radicand, and fraction bits of its square root and of the root's
  // inverse. Fixed.
  localparam int unsigned RootRadW    = 26;
  localparam int unsigned RootFrac    = 5;
  localparam int unsigned InverseFrac = UnitFrac + 1;
  // The root's CORDIC: shifts by 1, 2, ... up to CordicSteps - 1, CordicRepeat twice, from x = rad + C,
  // y = rad - C with C = 2^(RootRadW-2) / product of (1 - 4^-shift). Fixed.
  localparam int unsigned CordicSteps  = 11;
  localparam int unsigned CordicRepeat = 4;
  localparam int unsigned CordicStart  = 24461998;
  // A DSP multiplies signed numbers of so many bits.
  localparam int unsigned DspAW = 27;
  localparam int unsigned DspBW = 18;
  // A vector before it is normalised: grid steps of any CoordW, or a mixed normal. Fixed.
  localparam int unsigned SpanW = 29;
  // A column or row of a frame, and so the largest side of a frame. Fixed.
  localparam int unsigned PixelW       = 12;
  localparam int unsigned MaxFrameSize = 1 << PixelW;
  // Rays of a list: a ray's number takes the place of a column and a row. Fixed.
  localparam int unsigned MaxRays      = 1 << (2 * PixelW);
  // Fraction bits of a frame record's pitch and focal length, which are below one. Fixed.
  localparam int unsigned ScaleFrac = 44;
  // Fraction bits of an element of its matrix. Fixed.
  localparam int unsigned RotFrac = 30;
  // Integer and fraction bits of its checker's scale. Fixed.
  localparam int unsigned CheckerInt  = 10;
  localparam int unsigned CheckerFrac = 8;
  // A primitive's number; all ones stands for "none". Fixed: with it a slot of the image is full.
  localparam int unsigned PrimW = 21;
  // A reference's index of a node or a line: there are fewer than 2^22 of either. Fixed.
  localparam int unsigned LineW = 22;
  // Frames of a ray's stack, and the levels of a hierarchy that they are enough for: a level leaves one frame at most, and a
  // ray that starts at a tile's two nodes leaves one at each of two steps before it comes to the children of the root.
  localparam int unsigned StackFrames = 32;
  localparam int unsigned MaxLevels   = StackFrames - 1;
  // A context's number: up to 64 contexts a lane.
  localparam int unsigned CtxW = 6;

  // ---- The parameters of castray_core: what they are where nothing else is asked for ----
  localparam int unsigned DefaultLanes       = 3;    // 1 to 8
  localparam int unsigned DefaultContexts    = 32;   // rays in flight in each lane, 1 to 2^CtxW
  localparam int unsigned DefaultTileLog2    = 3;    // tiles of 4x4, 8x8 or 16x16 pixels: 2, 3 or 4
  localparam int unsigned DefaultPorts       = 2;    // of memory, 128 bits each: 1 or 2
  localparam int unsigned DefaultL2Kbytes    = 128;  // of the cache that all lanes share; 0: none
  localparam int unsigned DefaultAttrEntries = 128;  // places of the attribute cache

  // ---- Sizes in the core that are no parameters of it ----
  localparam int unsigned DefaultCacheLines  = 512;  // of leaves in each lane
  localparam int unsigned DefaultNodeLines   = 256;  // of nodes in each lane, beside as many places for those of tiles
  localparam int unsigned DefaultStartLines  = 128;  // of nodes to start tiles
  localparam int unsigned DefaultCacheWays   = 2;
  localparam int unsigned DefaultCacheMisses = 16;   // lines that one waits for
  localparam int unsigned DefaultL2Ways      = 4;
  localparam int unsigned DefaultL2Misses    = 24;   // lines that each port's bank waits for
  localparam int unsigned DefaultAttrMisses  = 16;   // lines that the attribute cache waits for
  localparam int unsigned DefaultRayBursts   = 8;    // bursts of a list's rays under way

  // Rays that wait before a lane: one tile's, and enough to bridge the setup of the next.
  function automatic int unsigned ray_queue(int unsigned tile_log2);
    return (tile_log2 < 3) ? 64 : 1 << (2 * tile_log2);
  endfunction

  // Tiles in flight: those whose rays are in the lanes and before them, and some to start ahead, to be
  // dealt, and to write behind.
  localparam int unsigned StartTiles = 8;   // whose start is sought at once: a power of two
  localparam int unsigned DealTiles  = 8;   // started, waiting for a lane
  localparam int unsigned WriteTiles = 6;
  function automatic int unsigned tile_slots(int unsigned lanes, int unsigned contexts, int unsigned tile_log2);
    return ((lanes * (contexts + ray_queue(tile_log2)) - 1) >> (2 * tile_log2)) + 1 + lanes + StartTiles
           + DealTiles + WriteTiles;
  endfunction

  // Nodes of tiles' frontiers that a lane keeps: two for each slot, rounded up to a power of two.
  function automatic int unsigned tile_nodes(int unsigned slots);
    return 2 << $clog2(slots);
  endfunction
endpackage
