// Runs first in main() and computes the attributes that VTK's code uses as the vertex. Follows
// relevoTerrainPositionVS.glsl.

#ifdef RELEVO_CELLS
uniform usamplerBuffer relevoFaceIds;
#endif
#ifdef RELEVO_NORMALS
// The definitions follow, because compilers warn where outputs are read before a line that sets them.
void relevoFindGradient(float detail);
vec3 relevoTerrainNormal();
#endif

void relevoDrawTerrain()
{
  ivec2 ab = relevoTakeFace();
  float height = relevoHeight(ab);
  vec2 samples = relevoSamples(ab);
#ifdef RELEVO_GLOBE
  bool isMissing = isnan(relevoGlobePosition.x); // of the height, or outside of the projection
  vec3 position = isMissing ? vec3(0.0) : relevoGlobePosition;
  relevoUpVSOutput = relevoGlobeTexel(ab, 1).xyz;
  relevoDerivativesVSOutput = relevoGlobeTexel(ab, 2);
#else
  bool isMissing = isnan(height);
  vec3 position = relevoMapPoint(samples, isMissing ? relevoOriginHeight : height);
#endif
  relevoMissingVSOutput = isMissing ? 1.0 : 0.0;
  vertexMC = vec4(position, 1.0);
  relevoRasterVSOutput = samples;
#ifdef RELEVO_NORMALS
  // The interpolation between vertices, which are about 2 pixels apart, is a filter, too.
  relevoFindGradient(relevoDetail(position) - 1.0);
  relevoSetNormal(relevoTerrainNormal());
#else
  relevoSetNormal(vec3(0.0, 0.0, 1.0)); // fragments have their own
#endif
#ifdef RELEVO_HEIGHTS
  relevoHeightVSOutput = isnan(height) ? 0.0 : height;
#endif
#ifdef RELEVO_CELLS
  relevoCellVSOutput = int(texelFetch(relevoFaceIds, relevoFace).r);
#endif
}
