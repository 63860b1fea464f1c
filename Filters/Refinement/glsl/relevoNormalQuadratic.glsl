// The PN triangle's quadratic normals, not normalised (Vlachos et al. 2001): they follow the
// inflections that linear ones lose.
// The including side provides vec3 cornerNormal(int) and edgeVector(edge, 2), the normal amid an
// edge, corners sorted.

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  precise vec3 n = cornerNormal(0) * (w.x * w.x);
  n += edgeVector(0, 2) * (w.x * w.y);
  n += edgeVector(2, 2) * (w.x * w.z);
  n += cornerNormal(1) * (w.y * w.y);
  n += edgeVector(1, 2) * (w.y * w.z);
  n += cornerNormal(2) * (w.z * w.z);
  return n;
}
