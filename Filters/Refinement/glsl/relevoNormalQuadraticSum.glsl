// A quadratic normal, not normalised, from one normal per corner and one at the midpoint of each
// edge (Vlachos, Peters, Boyd, Mitchell 2001). The including code provides edgeVector(edge, 2), the
// normal at the midpoint of an edge, with sorted corners.

RELEVO_FUNCTION vec3 quadraticNormal(vec3 n0, vec3 n1, vec3 n2, vec3 w)
{
  precise vec3 n = n0 * (w.x * w.x);
  n += edgeVector(0, 2) * (w.x * w.y);
  n += edgeVector(2, 2) * (w.x * w.z);
  n += n1 * (w.y * w.y);
  n += edgeVector(1, 2) * (w.y * w.z);
  n += n2 * (w.z * w.z);
  return n;
}
