// One face per instance, or several copies of a pattern for as many faces. Follows
// relevoPatternVS.glsl.

#ifdef RELEVO_INDIRECT
// range of the instance's faces in relevoInstances: first face, number of faces
in uvec2 relevoMembers;
#else
// first face of the group in relevoInstances, number of faces, and copies of the pattern per
// instance
uniform ivec3 relevoGroup;
#endif
uniform usamplerBuffer relevoInstances;
#ifdef RELEVO_MORPH
uniform samplerBuffer relevoMorphTags;

vec3 relevoMorphingTags()
{
  return texelFetch(relevoMorphTags, relevoFaceIndex).xyz;
}
#endif

// An instance may have more copies than faces.
int relevoInstance()
{
#ifdef RELEVO_LINES
  int copy = 0;
#else
  int copy = int(relevoPatternVertex.w);
#endif
#ifdef RELEVO_INDIRECT
  int member = int(relevoMembers.x) + copy;
  int end = int(relevoMembers.x + relevoMembers.y);
#else
  int member = relevoGroup.x + gl_InstanceID * relevoGroup.z + copy;
  int end = relevoGroup.x + relevoGroup.y;
#endif
  relevoHidden = member >= end;
  return int(texelFetch(relevoInstances, min(member, end - 1)).r);
}
