// SPDX-License-Identifier: Apache-2.0
// Bit widths of the arithmetic: the one place where each is chosen.
// docs/number-formats.md derives them; a unit that is made for one width refuses others at elaboration.
package castray_cfg_pkg;
  // Version of the core, major.minor.patch; the version register and `castray --version` show it.
  localparam int unsigned VersionMajor = 0;
  localparam int unsigned VersionMinor = 1;
  localparam int unsigned VersionPatch = 0;

  // A position: unsigned steps of the scene's grid from the scene's corner.
  localparam int unsigned CoordW = 26;
  // Fraction bits of the shear Sx, Sy of a ray.
  localparam int unsigned ShearFrac = 26;
  // Fraction bits of a distance along the dominant axis.
  localparam int unsigned TFrac = 4;
  // Fraction bits of u and v, the quotients of the hit divider.
  localparam int unsigned BaryFrac = 24;
  // Operand bits of the hit divider, after normalisation.
  localparam int unsigned HitDivW = 26;
  // Operand bits of the shear divider, after normalisation.
  localparam int unsigned ShearDivW = 32;
  // Fraction bits of a ray's direction before the division.
  localparam int unsigned DirFrac = 42;
  // Fraction bits of 1 + Sx^2 + Sy^2.
  localparam int unsigned NormFrac = 24;
  // Fraction bits of a unit normal, a weight and a facing ratio.
  localparam int unsigned UnitFrac = 16;
  // Fraction bits of the normaliser's square root.
  localparam int unsigned RootFrac = 5;
  // A primitive's number; all ones stands for "none".
  localparam int unsigned PrimW = 21;
  // A context's number: up to 64 contexts a lane.
  localparam int unsigned CtxW = 6;
endpackage
