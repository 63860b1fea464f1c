// A triangular patch with continuous tangent planes across its edges: a cubic Bezier triangle whose
// centre point is blended, depending on the position, between the inner points of the edges
// (Gregory 1974; Walton and Meek 1996). The including code provides relevoCubicPatch.glsl and vec3
// faceVector(int k): the inner point of edge k / 2 near its first (k even) or second corner (k
// odd). Edges are numbered as in relevoCubicPatch.glsl.

// Blends the inner points of two edges near their common corner. The weights are those of the
// corners at the other ends of the edges. If one is zero, the position is on the other edge and
// only that edge is used.
RELEVO_FUNCTION vec3 blendInnerPoints(vec3 a, vec3 b, float weightA, float weightB)
{
  float sum = weightA + weightB;
  return sum > 0.0f ? (a * weightA + b * weightB) / sum : a;
}

// The inner point near each corner.
RELEVO_FUNCTION vec3 innerPoint0(vec3 w)
{
  return blendInnerPoints(faceVector(0), faceVector(4), w.y, w.z);
}

RELEVO_FUNCTION vec3 innerPoint1(vec3 w)
{
  return blendInnerPoints(faceVector(1), faceVector(2), w.x, w.z);
}

RELEVO_FUNCTION vec3 innerPoint2(vec3 w)
{
  return blendInnerPoints(faceVector(5), faceVector(3), w.x, w.y);
}

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  return cubicPatch(w, weightedSum(innerPoint0(w), innerPoint1(w), innerPoint2(w), w));
}
