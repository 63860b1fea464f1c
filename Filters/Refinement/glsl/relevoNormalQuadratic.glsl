// Quadratic normals of PN triangles, not normalised. They show inflections that linear normals
// miss. The including code provides vec3 cornerNormal(int), with sorted corners, and
// quadraticNormal() of relevoNormalQuadraticSum.glsl.

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  return quadraticNormal(cornerNormal(0), cornerNormal(1), cornerNormal(2), w);
}
