// SPDX-License-Identifier: Apache-2.0
// Layout of the scene image, the one contract between host, model and RTL. All fields are
// little-endian; a struct's LAST field lies at its lowest address. docs/scene-image.md explains.
package castray_image_pkg;
  import castray_cfg_pkg::*;
  import castray_pkg::*;

  localparam logic [31:0] ImageMagic   = 32'h59525443;  // "CTRY"
  localparam logic [31:0] ImageVersion = 32'd2;
  localparam int unsigned ImageAlign   = 256;  // alignment of the image and of its sections, bytes
  localparam int unsigned BufferAlign  = 64;   // alignment of frame and hit buffers, bytes
  localparam int unsigned HeaderBytes  = 128;
  localparam int unsigned FrameBytes   = 128;  // the frame record follows the header
  localparam int unsigned SlotBytes    = 32;
  localparam int unsigned LineBytes    = 64;   // two slots
  localparam int unsigned NodeBytes    = 64;
  localparam int unsigned AttrBytes    = 64;
  localparam int unsigned HitBytes     = 32;
  localparam int unsigned RayBytes     = 64;
  localparam int unsigned PixelBytes   = 4;
  localparam logic [31:0] NoHit        = 32'hffffffff;  // number and instance in the record of a miss
  localparam logic [31:0] AnyHit       = 32'hfffffffe;  // number in the record of a ray that asked for any hit

  // What the fields of image and hit records are in units of, of the widths that may be chosen; the
  // fixed ones belong to the version. Compared whole: the layout is the same for all of them.
  localparam logic [31:0] ImageParameters =
    32'(CoordW) | (32'(ShearFrac) << 8) | (32'(TFrac) << 16) | (32'(BaryFrac) << 24);

  // A section: its first byte from the image's start, and how many records it holds.
  typedef struct packed {
    logic [31:0] count;
    logic [31:0] offset;
  } section_t;

  typedef struct packed {
    logic [383:0]       reserved;
    logic signed [63:0] corner_z;     // the scene's corner, grid steps from the world's origin
    logic signed [63:0] corner_y;
    logic signed [63:0] corner_x;
    logic [31:0]        unused;
    logic [31:0]        root;         // ref_word_t of the hierarchy's root
    section_t           nodes;        // node_t, parents before their children
    section_t           attributes;   // attr_t, one for each primitive, by number
    section_t           lines;        // pairs of prim_slot_t
    logic [31:0]        primitives;   // how many numbers are in use
    logic [31:0]        image_bytes;
    logic signed [31:0] grid_power;   // a step is 2^grid_power scene units
    logic [31:0]        parameters;   // ImageParameters
    logic [31:0]        version;
    logic [31:0]        magic;
  } image_header_t;

  // ---- Hierarchy ----
  typedef logic [31:0] ref_word_t;    // a ref_t below eight zero bits
  typedef logic [7:0]  plane_t;       // a plane on its node's grid
  typedef logic [4:0]  plane_exp_t;   // the grid's spacing is 2^exp steps
  localparam int unsigned MaxPlaneExp = 19;  // 255 << 19 reaches beyond every coordinate

  // A child's box: its low planes, then its high ones.
  typedef struct packed {
    plane_t z1, y1, x1;
    plane_t z0, y0, x0;
  } child_box_t;

  // A node of up to four children, from child 0 up. A plane lies at origin + (plane << exp).
  typedef struct packed {
    logic [98:0] reserved;
    child_box_t  box3;
    child_box_t  box2;
    child_box_t  box1;
    child_box_t  box0;
    ref_word_t   ref3;    // RefNone: there is no such child, and none behind it
    ref_word_t   ref2;
    ref_word_t   ref1;
    ref_word_t   ref0;
    plane_exp_t  exp_z;
    plane_exp_t  exp_y;
    plane_exp_t  exp_x;
    coord_t      z;       // the node's origin
    coord_t      y;
    coord_t      x;
  } node_t;

  typedef logic signed [RotFrac+1:0] rot_t;  // Q2.30, an element of the camera's matrix

  // The frame record: the camera and the paint of one picture.
  typedef struct packed {
    logic [287:0] reserved;
    logic [31:0]  stride;         // bytes from one row of the frame buffer to the next
    logic [23:0]  unused;
    logic [7:0]   pixel_format;   // 0 RGBA8, 1 BGRA8
    logic [15:0]  height;
    logic [15:0]  width;
    logic [31:0]  checker_scale;  // Q10.8
    logic [31:0]  colour_b;       // R in the lowest byte, then G, B
    logic [31:0]  colour_a;
    logic [31:0]  background;
    logic [63:0]  focal;          // Q0.44, focal length
    logic [63:0]  pitch;          // Q0.44, half the width of a pixel at the focal length
    rot_t         back_z;         // third column of the camera-to-world matrix
    rot_t         back_y;
    rot_t         back_x;
    rot_t         up_z;
    rot_t         up_y;
    rot_t         up_x;
    rot_t         right_z;
    rot_t         right_y;
    rot_t         right_x;
    logic [31:0]  eye_z;          // grid steps from the scene's corner
    logic [31:0]  eye_y;
    logic [31:0]  eye_x;
  } frame_record_t;

  localparam logic [7:0] PixelRgba8 = 8'd0;
  localparam logic [7:0] PixelBgra8 = 8'd1;

  localparam logic [7:0] MaterialChecker = 8'd0;  // the two colours by the checker's cell
  localparam logic [7:0] MaterialA       = 8'd1;  // the first colour only
  localparam logic [7:0] MaterialB       = 8'd2;  // the second colour only

  // Attributes of a primitive, 64 bytes. A sphere uses material and centre only.
  typedef struct packed {
    logic [46:0] reserved;
    logic        kind;
    logic [7:0]  material;
    point_t      centre;      // of a sphere
    tex_t        tc, sc;      // texture coordinates (s, t) of corners c, b, a
    tex_t        tb, sb;
    tex_t        ta, sa;
    unit3_t      face;        // the face's normal, for where the corners' cancel
    unit3_t      nc;          // unit normals of the corners
    unit3_t      nb;
    unit3_t      na;
  } attr_t;

  // A hit with its primitive's attributes: what the shader takes.
  typedef struct packed {
    attr_t attr;
    hit_t  hit;
  } shade_req_t;

  // One ray of a list.
  typedef struct packed {
    logic [95:0]        reserved;
    logic [31:0]        ignore;       // this primitive is not hit; NoHit: none
    logic signed [31:0] tmax;         // Q27.4; hits lie strictly between the two
    logic signed [31:0] tmin;
    logic signed [63:0] dir_z;        // Q3.42
    logic signed [63:0] dir_y;
    logic signed [63:0] dir_x;
    logic [31:0]        flags;        // see the Ray bits
    logic [31:0]        org_z;        // grid steps from the scene's corner
    logic [31:0]        org_y;
    logic [31:0]        org_x;
  } ray_record_t;

  // Bits of its flags.
  localparam int unsigned RayAnyHit   = 0;   // any hit will do
  localparam int unsigned RayCull     = 1;   // back faces are not hit
  localparam int unsigned NumRayFlags = 2;   // from bit 0 up

  // One record of the hit buffer.
  typedef struct packed {
    logic [31:0]        reserved;
    logic [31:0]        tests;        // of the ray, if they are asked for
    logic [31:0]        nodes;
    logic [31:0]        instance_id;  // 0: no instances; NoHit for a miss
    logic [31:0]        prim;         // NoHit for a miss; AnyHit: a primitive
    logic [31:0]        v;            // Q1.24
    logic [31:0]        u;            // Q1.24
    logic signed [31:0] t;            // Q27.4, TMax for a miss
  } hit_record_t;
endpackage
