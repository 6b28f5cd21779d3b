// SPDX-License-Identifier: Apache-2.0
// Refuses widths that the units are not made for, at elaboration, with a sentence for each. No ports,
// no logic; the units whose formats depend on them instantiate it.
module width_check
  import castray_cfg_pkg::*;
();
  if (CoordW < 20 || CoordW > 26) begin : g_coord
    $error("castray_cfg_pkg: CoordW is %0d, it must be 20 to 26: a sheared position is an operand of mul27", CoordW);
  end
  if (ShearFrac < 16 || ShearFrac > 26) begin : g_shear
    $error("castray_cfg_pkg: ShearFrac is %0d, it must be 16 to 26: a shear is an operand of mul27", ShearFrac);
  end
  if (TFrac < 2 || TFrac > 4) begin : g_t
    $error("castray_cfg_pkg: TFrac is %0d, it must be 2 to 4: roots come in quarter steps", TFrac);
  end
  if (BaryFrac < 12 || BaryFrac > 24) begin : g_bary
    $error("castray_cfg_pkg: BaryFrac is %0d, it must be 12 to 24", BaryFrac);
  end
  if (HitDivW < BaryFrac + 2 || HitDivW > 26) begin : g_hit_div
    $error("castray_cfg_pkg: HitDivW is %0d, it must be BaryFrac + 2 to 26", HitDivW);
  end
  if (ShearDivW < ShearFrac + 2 || ShearDivW > DirFrac + 3) begin : g_shear_div
    $error("castray_cfg_pkg: ShearDivW is %0d, it must be ShearFrac + 2 to DirFrac + 3", ShearDivW);
  end
  if (SubPlane < 2 || SubPlane > 6) begin : g_sub_plane
    $error("castray_cfg_pkg: SubPlane is %0d, it must be 2 to 6", SubPlane);
  end
  if (NormFrac != ShearFrac - 2) begin : g_norm
    $error("castray_cfg_pkg: NormFrac is %0d, it must be ShearFrac - 2", NormFrac);
  end
  if (DirFrac != 42 || UnitFrac != 16 || RootRadW != 26 || RootFrac != 5 || SpanW != 29) begin : g_fixed
    $error("castray_cfg_pkg: DirFrac, UnitFrac, RootRadW, RootFrac, SpanW are fixed: 42, 16, 26, 5, 29");
  end
  if (RecipW != 17 || DistW != 12 || DistFrac != 2) begin : g_boxes
    $error("castray_cfg_pkg: RecipW, DistW, DistFrac are fixed: 17, 12, 2");
  end
  if (CoordFieldW != 26 || PrimW != 21 || LineW != 22 || PixelW != 12) begin : g_fields
    $error("castray_cfg_pkg: CoordFieldW, PrimW, LineW, PixelW are fixed: 26, 21, 22, 12");
  end
  if (ScaleFrac != 44 || RotFrac != 30 || CheckerInt != 10 || CheckerFrac != 8) begin : g_frame
    $error("castray_cfg_pkg: ScaleFrac, RotFrac, CheckerInt, CheckerFrac are fixed: 44, 30, 10, 8");
  end
endmodule
