// Alpha of Phong tessellation, interpolated from one number per point.

RELEVO_FUNCTION float phongAlpha(vec3 w)
{
  return weightedSum(cornerValues(0), cornerValues(1), cornerValues(2), w).x;
}
