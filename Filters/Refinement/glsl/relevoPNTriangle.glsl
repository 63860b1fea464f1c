// The curved PN triangle: a cubic Bezier triangle (Vlachos, Peters, Boyd, Mitchell 2001). The
// including code provides relevoCubicPatch.glsl and vec3 faceVector(int k), k = 0: b111.

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  return cubicPatch(w, faceVector(0));
}
