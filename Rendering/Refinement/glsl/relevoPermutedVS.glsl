// A vertex where its pattern has it, or, morphing, where the tags of its face's edges move it.

#ifdef RELEVO_MORPH
vec3 relevoMorphingTags(); // of the sorted edges (0,1), (1,2), (0,2)
#endif

vec3 relevoPatternWeights(int code)
{
#ifdef RELEVO_MORPH
  return morphWeights(relevoPatternVertex.xyz, relevoMorphingTags());
#else
  return permuteWeights(relevoPatternVertex.xyz, code);
#endif
}
