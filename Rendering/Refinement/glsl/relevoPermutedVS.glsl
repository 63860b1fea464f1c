// A vertex where its pattern has it, or, morphing, where the tags of its face's edges move it. After
// relevoPatternVS.glsl and what has relevoMorphingTags(), those of the sorted edges.

vec3 relevoPatternWeights(int code)
{
#ifdef RELEVO_MORPH
  return morphWeights(relevoPatternVertex.xyz, relevoMorphingTags());
#else
  return permuteWeights(relevoPatternVertex.xyz, code);
#endif
}
