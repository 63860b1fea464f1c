// A vertex of a uniform pattern; on the border it moves to the points of the edges' own levels.
// Follows relevoPatternVS.glsl and relevoEdgeSegments.glsl.

vec3 relevoPatternWeights(int code)
{
  vec3 w = permuteWeights(relevoPatternVertex.xyz, code);
  return relevoSnapToSegments(w, relevoSegmentsOfFace(relevoFaceIndex));
}
