// The inputs of relevoFaceColorsFS.glsl.

#ifdef RELEVO_COLORS_OF_FACES
uniform samplerBuffer relevoFaceColors;

vec3 relevoFaceColor()
{
  return texelFetch(relevoFaceColors, relevoColorIndex()).rgb;
}
#endif

#ifdef RELEVO_COLORS_OF_TAGS
uniform samplerBuffer relevoTags; // per point, or per edge (0,1), (1,2), (0,2) of a face
uniform int relevoTagsPerEdge;

vec3 relevoFaceTags()
{
  return relevoTagsPerEdge == 1
    ? texelFetch(relevoTags, relevoFaceIndex).xyz
    : vec3(texelFetch(relevoTags, relevoFace.x).r, texelFetch(relevoTags, relevoFace.y).r,
        texelFetch(relevoTags, relevoFace.z).r);
}
#endif
