// Normals interpolated linearly, not normalised. The including code provides vec3
// cornerNormal(int), with sorted corners.

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  return weightedSum(cornerNormal(0), cornerNormal(1), cornerNormal(2), w);
}
