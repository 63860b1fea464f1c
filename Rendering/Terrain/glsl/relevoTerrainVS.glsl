// Runs first in main() and computes the attributes that VTK's code uses as the vertex. Follows
// relevoTerrainHeightsVS.glsl.

uniform ivec2 relevoOrigin;      // units of the finest lattice
uniform float relevoOriginHeight;
uniform vec4 relevoPlacement;    // world coordinates of a step to the next column and row
uniform float relevoHeightScale; // world units per unit of height
uniform vec4 relevoGradients;    // world derivatives of the derivatives by column and by row
uniform float relevoExaggeration;

#ifdef RELEVO_CELLS
uniform usamplerBuffer relevoFaceIds;
#endif

void relevoDrawTerrain()
{
  ivec2 ab = relevoTakeFace();
  vec3 vertex = relevoVertex(ab);
  // The same integers give the same position in all faces that share the vertex.
  vec2 samples = vec2((relevoFaceVertex(ab) << relevoUnitShift) - relevoOrigin) *
    relevoFractions[-RELEVO_FINEST_LEVEL];
  relevoMissingVSOutput = isnan(vertex.x) ? 1.0 : 0.0;
  precise vec3 position =
    vec3(samples.x * relevoPlacement.xy + samples.y * relevoPlacement.zw,
      isnan(vertex.x) ? 0.0 : (vertex.x - relevoOriginHeight) * relevoHeightScale);
  vec2 gradient = isnan(vertex.x)
    ? vec2(0.0)
    : vertex.y * relevoGradients.xy + vertex.z * relevoGradients.zw;
  vertexMC = vec4(position, 1.0);
  relevoSetNormal(normalize(vec3(-relevoExaggeration * gradient, 1.0)));
  relevoRasterVSOutput = samples;
#ifdef RELEVO_HEIGHTS
  relevoHeightVSOutput = isnan(vertex.x) ? 0.0 : vertex.x;
#endif
#ifdef RELEVO_GRADIENTS
  relevoGradientVSOutput = gradient;
#endif
#ifdef RELEVO_CELLS
  relevoCellVSOutput = int(texelFetch(relevoFaceIds, relevoFace).r);
#endif
}
