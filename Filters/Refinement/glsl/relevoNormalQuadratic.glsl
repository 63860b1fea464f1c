// The PN triangle's quadratic normals, not normalised: they follow the inflections that linear
// ones lose.
// The including side provides vec3 cornerNormal(int), corners sorted, and quadraticNormal() of
// relevoNormalQuadraticSum.glsl.

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  return quadraticNormal(cornerNormal(0), cornerNormal(1), cornerNormal(2), w);
}
