// A triangular patch with the tangent planes of its neighbours along its edges: a cubic Bezier
// triangle whose centre point goes, with the point looked for, from the one that an edge asks for
// to that of another (Gregory 1974; Walton and Meek 1996).
// The including side provides relevoCubicPatch.glsl and vec3 faceVector(int k): what edge k / 2
// asks for near its first (k even) or second corner (k odd). Edges as for relevoCubicPatch.glsl.

// What two edges ask for near the corner between them. The weights are those of the corners that
// the edges lead to: where one is zero, on the edge to the other, that edge alone counts.
RELEVO_FUNCTION vec3 blendInnerPoints(vec3 a, vec3 b, float weightA, float weightB)
{
  float sum = weightA + weightB;
  return sum > 0.0f ? (a * weightA + b * weightB) / sum : a;
}

// The same for each corner.
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
