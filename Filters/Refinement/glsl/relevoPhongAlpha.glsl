// Alpha of Phong tessellation as one number for the mesh.

uniform float relevoPhongAlpha;

RELEVO_FUNCTION float phongAlpha(RELEVO_UNUSED vec3 w)
{
  return relevoPhongAlpha;
}
