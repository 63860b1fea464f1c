// The linear surface: P = P0 w0 + P1 w1 + P2 w2 (Lenz 2009, eq. 3.4).
// The including code provides vec3 cornerPoint(int), with sorted corners.

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  return weightedSum(cornerPoint(0), cornerPoint(1), cornerPoint(2), w);
}
