// One coarse face per instance: its corners, and what the surface functions ask for.

in vec4 relevoPatternVertex; // (u, v, w) and the number of the copy, or for lines the pattern's
                             // edge they lie on (1 to 3), plus the pattern's number / 65536

#ifdef RELEVO_INDIRECT
in uvec2 relevoMembers; // where the instance's faces lie in relevoInstances, and how many they are
#else
uniform int relevoGroupOffset; // where the group's faces lie in relevoInstances
uniform int relevoGroupCount;  // and how many they are
uniform int relevoCopies;      // of the pattern in one instance
#endif
uniform usamplerBuffer relevoInstances; // face << 3 | permutation code
#ifdef RELEVO_MORPH
uniform samplerBuffer relevoMorphTags;  // of the sorted edges (0,1), (1,2), (0,2), per face
#endif
uniform isamplerBuffer relevoFaces;     // sorted corners; primitive << 3 | hidden edges
uniform samplerBuffer relevoPoints;     // VTK's vertexMC
uniform samplerBuffer relevoPointData;  // normal, u; frame of u; frame of v; direction; values
uniform samplerBuffer relevoVectors;    // the surface's vectors per face
uniform vec3 relevoPositionScale;       // from the mesh's lengths to vertexMC's
uniform vec3 relevoPositionShift;       // vertexMC is (position - shift) * scale

int relevoFaceIndex = 0;
ivec4 relevoFace = ivec4(0);
bool relevoHidden = false; // the vertex belongs to nothing that is to be seen

// Where in relevoInstances the vertex's face is. An instance may have more copies than faces.
int relevoMember()
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
  int member = relevoGroupOffset + gl_InstanceID * relevoCopies + copy;
  int end = relevoGroupOffset + relevoGroupCount;
#endif
  relevoHidden = member >= end;
  return min(member, end - 1);
}

vec4 relevoPointDatum(int id, int k)
{
  return texelFetch(relevoPointData, id * RELEVO_POINT_STRIDE + k);
}

int cornerId(int i)
{
  return relevoFace[i];
}

vec3 cornerPoint(int i)
{
  return texelFetch(relevoPoints, relevoFace[i]).xyz;
}

vec3 cornerNormal(int i)
{
#ifdef RELEVO_NORMALS
  return relevoPointDatum(relevoFace[i], 0).xyz;
#else
  return vec3(0.0);
#endif
}

vec3 cornerDirection(int i)
{
#ifdef RELEVO_DIRECTIONS
  return relevoPointDatum(relevoFace[i], RELEVO_POINT_DIRECTION).xyz;
#else
  return cornerNormal(i);
#endif
}

vec4 cornerValues(int i)
{
  return relevoPointDatum(relevoFace[i], RELEVO_POINT_VALUES);
}

vec3 surfaceScale()
{
  return relevoPositionScale;
}

vec3 modelPosition(vec3 p)
{
  return p / relevoPositionScale + relevoPositionShift;
}

vec3 edgeVector(int edge, int k)
{
  return texelFetch(relevoVectors,
    relevoFaceIndex * RELEVO_VECTORS_PER_FACE + edge * RELEVO_VECTORS_PER_EDGE + k).xyz;
}

vec3 faceVector(int k)
{
  return texelFetch(relevoVectors,
    relevoFaceIndex * RELEVO_VECTORS_PER_FACE + 3 * RELEVO_VECTORS_PER_EDGE + k).xyz;
}
