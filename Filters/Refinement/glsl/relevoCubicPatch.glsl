// A cubic Bezier triangle whose centre point b111 is an argument. The including code provides, with
// sorted corners,
//   vec3 cornerPoint(int i)           b300, b030, b003
//   vec3 edgeVector(int edge, int k)  edge 0 = corners 0 1, 1 = corners 1 2, 2 = corners 0 2;
//                                     k = 0 the control point near the first corner, 1 the other
// Terms are in the order of their corners (see relevoWeights.glsl).

RELEVO_FUNCTION vec3 cubicPatch(vec3 w, vec3 centre)
{
  vec3 w2 = w * w;
  precise vec3 p = cornerPoint(0) * (w2.x * w.x);
  p += edgeVector(0, 0) * (3.0f * w2.x * w.y);
  p += edgeVector(2, 0) * (3.0f * w2.x * w.z);
  p += edgeVector(0, 1) * (3.0f * w2.y * w.x);
  p += centre * (6.0f * w.x * w.y * w.z);
  p += edgeVector(2, 1) * (3.0f * w2.z * w.x);
  p += cornerPoint(1) * (w2.y * w.y);
  p += edgeVector(1, 0) * (3.0f * w2.y * w.z);
  p += edgeVector(1, 1) * (3.0f * w2.z * w.y);
  p += cornerPoint(2) * (w2.z * w.z);
  return p;
}
