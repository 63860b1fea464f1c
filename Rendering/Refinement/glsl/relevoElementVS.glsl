// Draws one face per draw call. Follows relevoPatternVS.glsl.

uniform int relevoElement;

int relevoInstance()
{
  return relevoElement;
}

#ifdef RELEVO_MORPH
uniform vec3 relevoElementTags;

vec3 relevoMorphingTags()
{
  return relevoElementTags;
}
#endif
