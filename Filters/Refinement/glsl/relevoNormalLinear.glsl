// Normals interpolated linearly, not normalised.
// The including side provides vec3 cornerNormal(int), corners sorted.

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  return weightedSum(cornerNormal(0), cornerNormal(1), cornerNormal(2), w);
}
