// Quadratic normals of the scalar-tagged surface, not normalised. Each corner has a normal for each
// of its two edges. The including code provides faceVector(1 + 2 i) and faceVector(2 + 2 i), the
// normals of sorted corner i for its edges to the lower and the higher of the other corners, and
// quadraticNormal() of relevoNormalQuadraticSum.glsl.

// A corner's normal for the weights of the lower and the higher of the other corners. Interpolation
// starts at the normal of the nearer edge, so that it is exact on both edges and where both normals
// are equal.
RELEVO_FUNCTION vec3 normalBetweenEdges(int corner, float low, float high)
{
  vec3 a = faceVector(1 + 2 * corner);
  vec3 b = faceVector(2 + 2 * corner);
  float sum = low + high;
  precise vec3 n = low < high ? b + (a - b) * (low / sum)
                              : a + (b - a) * (sum > 0.0f ? high / sum : 0.5f);
  return n;
}

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  return quadraticNormal(normalBetweenEdges(0, w.y, w.z), normalBetweenEdges(1, w.x, w.z),
    normalBetweenEdges(2, w.x, w.y), w);
}
