// One coarse face: its corners, and the inputs of the surface functions. The method assigns a
// vertex to its face, and defines these functions:
//     vec3 relevoPlaceVertex()  returns the weights of the sorted corners, and sets relevoFaceIndex
//                               and relevoHidden
//     int relevoColorIndex()    returns the index of the face's colour in relevoFaceColors
//     int relevoLineEdges()     returns, in wireframes, the face's sorted edge that the line is on,
//                               as a bit of the hidden edges in relevoFaces; 0 for none

uniform isamplerBuffer relevoFaces;     // sorted corners; primitive << 3 | hidden edges
uniform samplerBuffer relevoPoints;     // VTK's vertexMC
uniform samplerBuffer relevoPointData;  // normal, u; frame of u; frame of v; direction; values
uniform samplerBuffer relevoVectors;    // the surface's vectors per face
uniform vec3 relevoPositionScale;       // from units of the mesh to units of vertexMC
uniform vec3 relevoPositionShift;       // vertexMC is (position - shift) * scale

#ifdef RELEVO_TABLES
uniform isamplerBuffer relevoTableEntries; // per face: first record << 3 | order of corners
uniform isamplerBuffer relevoTableRecords;
uniform samplerBuffer relevoTablePoints;
#endif

int relevoFaceIndex = 0;
ivec4 relevoFace = ivec4(0);
bool relevoHidden = false; // the vertex is not visible

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

#ifdef RELEVO_TABLES
int tableEntry()
{
  return texelFetch(relevoTableEntries, relevoFaceIndex).x >> 3;
}

int cornerOrder()
{
  return texelFetch(relevoTableEntries, relevoFaceIndex).x & 7;
}

vec4 tablePoint(int i)
{
  return texelFetch(relevoTablePoints, i);
}

ivec4 tableRecord(int i)
{
  return texelFetch(relevoTableRecords, i);
}
#endif
