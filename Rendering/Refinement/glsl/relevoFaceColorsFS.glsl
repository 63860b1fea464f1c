// The colour of a fragment by its face's level or pattern, or by the metric's tags.

#ifdef RELEVO_COLORS_OF_TAGS
uniform int relevoTagsPerEdge;
uniform float relevoTagOffset;
uniform float relevoHighestTag;
#endif

vec3 relevoFragmentColor()
{
#ifdef RELEVO_COLORS_OF_TAGS
  // An edge shows its own tag; a corner shows the mean of its two edges' tags.
  vec3 corners = max(relevoTagWeightsVSOutput, vec3(0.0)) + 1e-4;
  vec3 edges = corners * corners.yzx; // (0,1), (1,2), (2,0)
  vec3 weights =
    relevoTagsPerEdge == 1 ? edges / (edges.x + edges.y + edges.z) : relevoTagWeightsVSOutput;
  float tag = dot(weights, relevoTagsVSOutput) + relevoTagOffset;
  return relevoTableColor(clamp(tag, 0.0, relevoHighestTag)).rgb;
#else
  return relevoColorVSOutput;
#endif
}
