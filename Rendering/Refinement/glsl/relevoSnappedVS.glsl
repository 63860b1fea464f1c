// A vertex of a uniform pattern, those on the border where the edges' own levels have points. After
// relevoPatternVS.glsl and relevoEdgeSegments.glsl.

vec3 relevoPatternWeights(int code)
{
  vec3 w = permuteWeights(relevoPatternVertex.xyz, code);
  return relevoSnapToSegments(w, relevoSegmentsOfFace(relevoFaceIndex));
}
