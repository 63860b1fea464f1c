// A vertex at its position in the pattern or, when morphing, moved by the tags of its face's edges.
// Follows relevoPatternVS.glsl and the file that defines relevoMorphingTags() for the sorted edges.

vec3 relevoPatternWeights(int code)
{
#ifdef RELEVO_MORPH
  return morphWeights(relevoPatternVertex.xyz, relevoMorphingTags());
#else
  return permuteWeights(relevoPatternVertex.xyz, code);
#endif
}
