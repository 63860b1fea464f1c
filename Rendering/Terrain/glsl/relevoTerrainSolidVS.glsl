// Runs first in main(), in place of relevoTerrainVS.glsl, for the bottom of a solid, and for the faces
// at its borders with their walls (RELEVO_BORDER). Follows relevoTerrainPositionVS.glsl.

uniform float relevoBaseHeight;
#ifdef RELEVO_BORDER
uniform usamplerBuffer relevoBorder; // face; vertices, their number, base, side; two weights
#endif
#ifdef RELEVO_CELLS
uniform usamplerBuffer relevoFaceIds;
#endif

void relevoBegin()
{
  vertexMC = vec4(0.0, 0.0, 0.0, 1.0);
  relevoRasterVSOutput = vec2(0.0);
  relevoMissingVSOutput = 0.0;
#ifdef RELEVO_GLOBE
  relevoUpVSOutput = vec3(0.0);
  relevoDerivativesVSOutput = vec4(0.0);
#endif
#ifdef RELEVO_HEIGHTS
  relevoHeightVSOutput = 0.0;
#endif
}

// Add a vertex of the face to the mean that the shader draws.
void relevoAdd(ivec2 ab, float weight, bool isAtBase)
{
  float height = relevoBaseHeight;
  if (!isAtBase)
  {
    height = relevoHeight(ab);
  }
  vec2 samples = relevoSamples(ab);
#ifdef RELEVO_GLOBE
  vec3 position = relevoGlobePosition;
  if (isAtBase)
  {
    position = relevoGlobePoint(ab, height);
  }
  relevoUpVSOutput += weight * relevoGlobeTexel(ab, 1).xyz;
  relevoDerivativesVSOutput += weight * relevoGlobeTexel(ab, 2);
#else
  vec3 position = relevoMapPoint(samples, height);
#endif
  precise vec3 sum = vertexMC.xyz + weight * position;
  vertexMC.xyz = sum;
  relevoRasterVSOutput += weight * samples;
#ifdef RELEVO_HEIGHTS
  relevoHeightVSOutput += weight * height;
#endif
}

void relevoDrawTerrain()
{
  relevoBegin();
#ifdef RELEVO_BORDER
  uvec4 vertex = texelFetch(relevoBorder, gl_VertexID);
  relevoHidden = false;
  relevoLoadFace(int(vertex.x));
  int number = int(vertex.y >> 24) & 3;
  bool isAtBase = (vertex.y & (1u << 26)) != 0u;
  relevoSideVSOutput = int(vertex.y >> 27);
  vec2 weights = uintBitsToFloat(vertex.zw);
  for (int i = 0; i < number; ++i)
  {
    int ab = int(vertex.y >> (8 * i));
    float weight = i == 0 ? weights.x : (i == 1 ? weights.y : 1.0 - weights.x - weights.y);
    relevoAdd(ivec2(ab & 15, (ab >> 4) & 15), weight, isAtBase);
  }
#else
  ivec2 ab = relevoTakeFace();
  relevoSideVSOutput = RELEVO_BOTTOM;
  relevoAdd(ab, 1.0, true);
#endif
  relevoSetNormal(vec3(0.0, 0.0, 1.0)); // fragments have their own
#ifdef RELEVO_CELLS
  relevoCellVSOutput = int(texelFetch(relevoFaceIds, relevoFace).r);
#endif
}
