// SPDX-License-Identifier: Apache-2.0
// Formats and records of every stream. C++ reads this file too: tools/sv_records.py turns each
// type into a struct of the same name with the same fields, packed the same way.
package castray_pkg;
  import castray_cfg_pkg::*;

  // ---- Formats. Qi.f: i integer bits with the sign where there is one, f fraction bits ----
  typedef logic [CoordFieldW-1:0]          coord_t;    // grid steps from the scene's corner, below 2^CoordW
  typedef logic signed [CoordW:0]          delta_t;    // difference of two positions, steps
  typedef logic signed [CoordW:0]          sheared_t;  // sheared position, units of two steps
  typedef logic signed [ShearFrac:0]       shear_t;    // Q1.26, magnitude below one
  typedef logic signed [2*CoordW+2:0]      edge_fn_t;  // edge function, units of four square steps
  typedef logic [2*CoordW+2:0]             area_t;     // its magnitude
  typedef logic [2*CoordW+3:0]             det_t;      // the sum of three
  typedef logic signed [CoordW+5:0]        towards_t;  // along a ray not normalised, quarter steps
  typedef logic [NormFrac+1:0]             norm2_t;    // Q2.24, 1 + Sx^2 + Sy^2
  typedef logic signed [CoordW+TFrac:0]    t_t;        // Q27.4, steps along the dominant axis
  typedef logic [BaryFrac:0]               bary_t;     // Q1.24, zero to one inclusive
  typedef logic signed [DirFrac+2:0]       dir_comp_t; // Q3.42
  typedef logic signed [DirFrac+1:0]       dir_step_t; // Q2.42
  typedef logic signed [UnitFrac+1:0]      unit_t;     // Q2.16
  typedef logic signed [TexInt+UnitFrac-1:0] tex_t;      // Q11.16, texture coordinate
  typedef logic signed [DspAW-1:0]         mul27_t;    // operand and product of mul27
  typedef logic signed [2*DspAW-1:0]       mul54_t;
  typedef logic signed [2*DspAW:0]         mul_sum_t;  // of two products
  typedef logic signed [63:0]              mul_part_t; // of a product, see mul27_parts
  typedef logic [PrimW-1:0]                prim_t;
  typedef logic [CtxW-1:0]                 ctx_t;
  typedef logic [1:0]                      axis_t;     // 0 x, 1 y, 2 z
  typedef logic [DistW-1:0]                dist_t;     // t[CoordW+TFrac-1 -: DistW] of a t_t, zero for a negative one
  typedef logic [PixelW-1:0]               pixel_t;    // column or row of a frame
  typedef logic [PixelW:0]                 extent_t;   // a number of them, up to MaxFrameSize
  typedef logic [2*PixelW-1:0]             ray_no_t;   // a ray's number in a list
  typedef logic [2*PixelW:0]               ray_count_t; // how many there are, up to MaxRays

  localparam prim_t  NoPrim = '1;
  localparam t_t     TMax   = t_t'((1 << (CoordW + TFrac)) - 1);

  // Kinds of primitive.
  localparam logic KindTriangle = 1'b0;
  localparam logic KindSphere   = 1'b1;

  typedef struct packed { coord_t x, y, z; }    point_t;
  typedef struct packed { dir_comp_t x, y, z; } dir_t;
  typedef struct packed { dir_step_t x, y, z; } dir_step3_t;
  typedef struct packed { unit_t x, y, z; }     unit3_t;

  // ---- Camera ----
  typedef logic signed [PixelW:0] offset_t;   // from a frame's centre, half pixels

  // One pixel of the walk. slot: the tile's place in the gather buffer. Of a ray of a list {y, x} is
  // its number.
  typedef struct packed {
    logic [7:0] slot;
    pixel_t     y;
    pixel_t     x;
  } pixel_tag_t;

  // One tile, clipped to the window: its first pixel, its size, its place in the gather buffer.
  typedef struct packed {
    logic [7:0] slot;
    logic [4:0] height;
    logic [4:0] width;
    pixel_t     y;
    pixel_t     x;
  } tile_t;

  // The camera of a frame, made once a job by frame_setup from the frame record.
  typedef struct packed {
    point_t     eye;
    dir_step3_t right;   // one column to the right, half a pixel's width: see ray_gen
    dir_step3_t up;
    dir_step3_t ahead;   // the camera's axis, focal length included
    extent_t    width;
    extent_t    height;
  } camera_t;

  typedef struct packed {
    pixel_tag_t tag;
    dir_t       dir;
  } pixel_dir_t;

  // A ray that is asked for, of a camera or of a list, before its shear is divided.
  typedef struct packed {
    pixel_tag_t tag;
    point_t     org;
    dir_t       dir;
    t_t         tmin;     // as in ray_t
    t_t         tmax;
    logic       cull;
    logic       any_hit;
    logic       ok;       // false: it hits nothing, whatever the rest is
    prim_t      ignore;
  } ray_req_t;

  // One over the magnitude of a component S of the shear, rounded down:
  //   mant 2^(exp-16) <= 1 / |S| <= (mant + 1) 2^(exp-16)      2^16 <= mant
  // zero: S is 0; then mant is 2^16 and exp 31, beyond any other.
  typedef struct packed {
    logic              zero;
    logic              minus;   // S is negative
    logic [4:0]        exp;
    logic [RecipW-1:0] mant;
  } recip_t;

  // A ray as a lane sees it: origin and shear on permuted axes, dominant axis and its sign.
  typedef struct packed {
    pixel_tag_t tag;
    point_t     org;
    shear_t     sx;
    shear_t     sy;
    norm2_t     norm2;
    axis_t      axis;
    logic       neg;      // the direction's dominant component is negative
    logic       valid;    // false: nothing is hit; the direction is zero, or it was not ok
    logic       cull;     // back faces are not hit
    logic       any_hit;  // any hit will do
    t_t         tmin;     // hits lie strictly between tmin and tmax
    t_t         tmax;
    prim_t      ignore;   // this primitive is not hit; NoPrim: none
    recip_t     rx;       // of sx and sy, filled in by slab_setup
    recip_t     ry;
  } ray_t;

  // ---- Primitives ----
  // One slot of the primitive buffer, 256 bits: a triangle's corners, or a sphere's centre in a
  // and its radius in b.x. number == NoPrim: an empty slot.
  typedef struct packed {
    logic   kind;
    prim_t  number;
    point_t c;
    point_t b;
    point_t a;
  } prim_slot_t;

  // ---- Hierarchy ----
  // Where a ray goes: a node or a leaf (a line of the primitive buffer) by its index.
  typedef logic [LineW-1:0] line_t;
  localparam logic [1:0] RefNone = 2'd0;
  localparam logic [1:0] RefNode = 2'd1;
  localparam logic [1:0] RefLeaf = 2'd2;
  localparam logic [1:0] RefTile = 2'd3;   // an entry of a tile's frontier: on chip only
  typedef struct packed {
    logic [1:0] kind;
    line_t      index;
  } ref_t;

  // What the node pipe needs of a ray.
  typedef struct packed {
    point_t org;
    axis_t  axis;
    logic   neg;
    recip_t rx;
    recip_t ry;
    t_t     tmin;
  } slab_ray_t;

  // Positions along a ray in ticks from the first of a node's planes across the dominant axis: of one
  // inside the node, and of a plane across another axis, in ticks of its own.
  typedef logic [SubPlane+7:0]         tick_t;
  typedef logic signed [SubPlane+12:0] slab_t;

  // A child still to be visited, and the least t of what its box holds, margin included: the child
  // may be dropped if that is greater than the upper bits of the nearest t.
  typedef struct packed {
    dist_t least;
    ref_t  target;
  } entry_t;

  // The children of a node that a ray visits, e0 first; RefNone and zero behind the last.
  typedef struct packed {
    entry_t e3, e2, e1, e0;
  } visits_t;

  // Where a ray starts: one reference or two; a ray that starts nowhere hits nothing.
  typedef struct packed {
    ref_t second;
    ref_t first;
  } start_t;

  // Children left behind on a ray's stack, near to far; RefNone ends them.
  typedef struct packed { entry_t e2, e1, e0; } frame_t;

  // ---- Tiles ----
  localparam int unsigned TileSlopeFrac = 16;
  typedef logic signed [TileSlopeFrac+1:0] tile_slope_t;   // Q2.16, a component of a direction along the ray
  // What dx/dt and dy/dt of a tile's rays lie between, t along their common dominant axis.
  typedef struct packed {
    logic        valid;   // they have one, and its sign
    axis_t       axis;
    logic        neg;
    tile_slope_t x_low, x_high;
    tile_slope_t y_low, y_high;
  } tile_bounds_t;

  // A box, both corners included.
  typedef struct packed { point_t high, low; } box_t;

  // On axes permuted so that the dominant one comes last.
  function automatic point_t permute(point_t p, axis_t axis);
    return '{x: (axis == 2'd0) ? p.y : (axis == 2'd1) ? p.z : p.x,
             y: (axis == 2'd0) ? p.z : (axis == 2'd1) ? p.x : p.y,
             z: (axis == 2'd0) ? p.x : (axis == 2'd1) ? p.y : p.z};
  endfunction

  // A part of the scene that some ray of a tile may meet.
  typedef struct packed {
    box_t box;
    ref_t target;
  } part_t;
  localparam int unsigned TileParts = 8;   // of a tile's frontier, at most: two nodes
  localparam int unsigned TileReads = 64;  // nodes read for it, at most

  // How a tile's rays start: nowhere, at the root, or at its frontier of one node or two.
  localparam logic [1:0] TileEmpty = 2'd0;
  localparam logic [1:0] TileRoot  = 2'd1;
  localparam logic [1:0] TileOne   = 2'd2;
  localparam logic [1:0] TileTwo   = 2'd3;
  typedef struct packed {
    logic [1:0] start;
    tile_t      tile;
  } started_t;
  typedef logic [2:0] lane_no_t;

  // What was done for a ray: the nodes it visited, and its tests, at most eight for each node.
  typedef logic [23:0] steps_t;
  typedef logic [26:0] tests_t;
  typedef struct packed {
    tests_t tests;
    steps_t nodes;
  } work_t;

  // What the primitive pipe needs of a ray.
  typedef struct packed {
    point_t org;
    shear_t sx;
    shear_t sy;
    norm2_t norm2;
    axis_t  axis;
    logic   neg;
    logic   cull;
  } test_ray_t;

  // A primitive accepted by the exact test; what is left is to divide.
  // Triangle: |U|, |V|, |det| and the dominant coordinates of the origin from its corners.
  // Sphere: det holds the discriminant in units of two square steps, az the projection
  // X Sx + Y Sy (in quarter steps, see hit_unit), cz the dominant coordinate of the origin from the centre.
  typedef struct packed {
    ctx_t         ctx;
    prim_t        number;
    logic         kind;
    area_t        u;
    area_t        v;
    det_t         det;
    towards_t     az;
    delta_t       bz;
    delta_t       cz;
  } cand_t;

  // What the hit unit needs of a ray.
  typedef struct packed {
    norm2_t norm2;
    logic   neg;
    logic   cull;
    t_t     tmin;
  } hit_ray_t;

  // A candidate with its distance.
  typedef struct packed {
    ctx_t  ctx;
    prim_t number;
    logic  kind;
    t_t    t;
    bary_t u;
    bary_t v;
  } result_t;

  // Bits of a candidate's place in the hit unit, which checks that they are enough: it holds fewer than 2^HitPlaceW.
  localparam int unsigned HitPlaceW = 6;

  // The nearest hit of a ray, with what shading needs of the ray.
  typedef struct packed {
    pixel_tag_t tag;
    logic       found;
    logic       any_hit;  // the ray asked for any hit: which one was found, and where, says nothing
    logic       kind;
    prim_t      number;
    t_t         t;
    bary_t      u;
    bary_t      v;
    shear_t     sx;
    shear_t     sy;
    axis_t      axis;
    logic       neg;
  } hit_t;

  // A ray's hit, and what was done for it.
  typedef struct packed {
    work_t work;
    hit_t  hit;
  } cast_t;

  // ---- Shading ----
  typedef struct packed { logic [7:0] b, g, r; } rgb_t;

  // A vector before it is normalised: a corner normal's units, grid steps, or a direction's.
  typedef logic signed [SpanW-1:0] span_t;
  typedef struct packed { span_t x, y, z; } span3_t;

  // A triangle's attributes at the hit.
  typedef struct packed {
    span3_t normal;   // not normalised, Q3.26
    tex_t   s;
    tex_t   t;
  } smooth_t;

  // What paint takes: the unit vectors of a hit and what its colour depends on.
  typedef struct packed {
    pixel_tag_t tag;
    logic       kind;
    logic [7:0] material;
    tex_t       s;
    tex_t       t;
    unit3_t     normal;
    unit3_t     view;   // along the ray, either way
  } paint_req_t;

  typedef logic [CheckerInt+CheckerFrac-1:0] checker_t;  // Q10.8 cells for each unit of texture coordinate

  // The materials' parameters of a frame, from the frame record.
  typedef struct packed {
    rgb_t        background;
    rgb_t        colour_a;
    rgb_t        colour_b;
    checker_t    checker_scale;
    logic        swap_rb;        // pixel format BGRA
  } paint_t;

  typedef struct packed {
    pixel_tag_t  tag;
    logic [31:0] colour;
  } shaded_t;

  // ---- Memory ----
  localparam int unsigned AddrW  = 40;
  localparam int unsigned DataW  = 128;
  localparam int unsigned StrbW  = DataW / 8;
  localparam int unsigned BeatsW = 5;   // 1 to 16 beats a burst
  typedef logic [AddrW-1:0]  addr_t;
  typedef logic [DataW-1:0]  beat_t;

  // A line of 64 bytes, counted from the image's start: an image has at most 4 GiB.
  localparam int unsigned LineNoW = 26;
  typedef logic [LineNoW-1:0] line_no_t;
  typedef logic [4*DataW-1:0] line_data_t;
  // The lines that a cache waits for have numbers: it asks for a line and gets it under one.
  localparam int unsigned MissW = 5;
  typedef logic [MissW-1:0]   miss_t;
  typedef struct packed {
    miss_t    miss;
    line_no_t line;
  } line_req_t;
  typedef struct packed {
    miss_t      miss;
    line_data_t data;
  } line_fill_t;

  // Clients of the read arbiter, in this order.
  localparam int unsigned ReadClients   = 4;
  localparam int unsigned ReadJob       = 0;
  localparam int unsigned ReadPrimitive = 1;
  localparam int unsigned ReadAttribute = 2;
  localparam int unsigned ReadRay       = 3;
  // Clients of the write arbiter.
  localparam int unsigned WriteClients = 2;
  localparam int unsigned WritePixel   = 0;
  localparam int unsigned WriteHit     = 1;

  // What the lanes need to know of an image's hierarchy.
  typedef struct packed {
    steps_t      limit;        // nodes that a ray may visit
    logic [31:0] primitives;   // numbers are below it
    logic [31:0] leaf_count;
    line_no_t    leaf_base;
    logic [31:0] node_count;
    line_no_t    node_base;
  } tree_t;

  // What a lane did in a cycle, for the counters.
  typedef struct packed {
    logic node;        // a node was tested
    logic test;        // a primitive was tested
    logic cand;        // a test was accepted
    logic node_hit;    // lookups of the caches
    logic node_miss;
    logic leaf_hit;
    logic leaf_miss;
    logic node_wait;   // a context waits for a lookup
    logic leaf_wait;
    logic test_wait;   // a test waits for the hit unit's queue
  } lane_events_t;

  // The same of all lanes, a bit each.
  localparam int unsigned MaxLanes = 8;
  typedef logic [MaxLanes-1:0] by_lane_t;
  typedef struct packed {
    by_lane_t node, test, cand, node_hit, node_miss, leaf_hit, leaf_miss, node_wait, leaf_wait, test_wait;
  } lane_sums_t;

  // A burst of beats from addr, which is aligned so that it stays inside a 4 KiB page.
  typedef struct packed {
    addr_t             addr;
    logic [BeatsW-1:0] beats;
  } read_req_t;

  typedef struct packed {
    logic  last;
    beat_t data;
  } read_rsp_t;

  // A whole write burst in one item: up to 64 bytes, aligned to its own size.
  typedef struct packed {
    addr_t             addr;
    logic [2:0]        beats;   // 1, 2 or 4
    logic [63:0]       strb;
    logic [511:0]      data;
  } write_req_t;

  // ---- Control ----
  // The arguments of a job, latched at its start.
  typedef struct packed {
    addr_t       image;
    addr_t       frame;
    addr_t       hits;
    addr_t       rays;          // of a list
    logic [31:0] image_bytes;
    logic [31:0] frame_bytes;
    logic [31:0] hits_bytes;
    logic [31:0] ray_bytes;
    ray_count_t  ray_count;
    extent_t     width;
    extent_t     height;
    extent_t     x0;            // the window that is rendered: x0 <= x < x1, y0 <= y < y1
    extent_t     y0;
    extent_t     x1;
    extent_t     y1;
    logic        is_list;        // a list of rays, no frame
    logic        want_hits;     // of a list: always
    logic        want_work;     // the records hold what was done for each ray
    logic        z_order;       // tiles along a Z curve, else in rows
    logic        brute;         // every ray against every primitive
    logic        from_root;     // every ray starts at the root
    steps_t      steps;         // nodes that a ray may visit
    logic        illegal;       // a register held bits outside its field
  } job_t;

  // Error codes, and what people are told of them (docs/register-map.md says more).
  typedef enum logic [7:0] {
    ErrNone        = 8'd0,   // the job was done
    ErrRegister    = 8'd1,   // a register holds an illegal value
    ErrImage       = 8'd2,   // no scene image is there, or one of another version
    ErrParameters  = 8'd3,   // the image is for other bit widths
    ErrSection     = 8'd4,   // a section of the image is not aligned or lies outside it, or is too short for the primitives
    ErrFrameRecord = 8'd5,   // the frame record is for another frame size, or a field of it is out of range
    ErrFrameWindow = 8'd6,   // the frame buffer is too small
    ErrHitWindow   = 8'd7,   // the hit buffer is too small
    ErrReadBus     = 8'd8,   // the memory answered a read with an error
    ErrWriteBus    = 8'd9,   // the memory answered a write with an error
    ErrPrimitive   = 8'd10,  // a primitive's number is out of range
    ErrNode        = 8'd11,  // a node is illegal, out of range, or not behind its parent
    ErrLeaf        = 8'd12,  // a leaf is out of range
    ErrStack       = 8'd13,  // the hierarchy is deeper than a ray's stack
    ErrSteps       = 8'd14,  // a ray visited more nodes than the job allows
    ErrRay         = 8'd15,  // a ray of the list has a flag that is none
    ErrRayWindow   = 8'd16   // the list of rays ends behind its window
  } error_t;
endpackage
