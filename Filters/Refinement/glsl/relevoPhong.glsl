// Phong tessellation (Boubekeur, Alexa 2008): the point p of the plane triangle moves towards p*,
// the weighted mean of its projections to the corners' tangent planes.
//
// If faces have different normals at a point (RELEVO_DIRECTIONS), edges are shared by evaluating a
// quadratic Bezier patch, p* - p = 2 sum w_i w_j (b_ij - (P_i + P_j) / 2), with the mean of both
// sides' b. Otherwise the definition is used, which reads three vectors less: a tenth of a vertex's
// time.
//
// The including code provides, with sorted corners,
//   vec3 cornerPoint(int i), vec3 cornerNormal(int i), vec3 surfaceScale()
//   vec3 edgeVector(int edge, 0)  b: edge 0 = corners 0 1, 1 = corners 1 2, 2 = corners 0 2
//   float phongAlpha(vec3 w)      the fraction of the way
// Terms are in the order of their corners (see relevoWeights.glsl).

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  vec3 p0 = cornerPoint(0);
  vec3 p1 = cornerPoint(1);
  vec3 p2 = cornerPoint(2);
  precise vec3 p = weightedSum(p0, p1, p2, w);
#ifdef RELEVO_DIRECTIONS
  precise vec3 way = (edgeVector(0, 0) - 0.5f * (p0 + p1)) * (2.0f * w.x * w.y);
  way += (edgeVector(2, 0) - 0.5f * (p0 + p2)) * (2.0f * w.x * w.z);
  way += (edgeVector(1, 0) - 0.5f * (p1 + p2)) * (2.0f * w.y * w.z);
#else
  vec3 perLength = vec3(1.0f) / surfaceScale();
  vec3 n0 = cornerNormal(0);
  vec3 n1 = cornerNormal(1);
  vec3 n2 = cornerNormal(2);
  precise vec3 way = n0 * (dot((p0 - p) * perLength, n0) * w.x);
  way += n1 * (dot((p1 - p) * perLength, n1) * w.y);
  way += n2 * (dot((p2 - p) * perLength, n2) * w.z);
  way *= surfaceScale();
#endif
  p += way * phongAlpha(w);
  return p;
}
