// The gradient of a terrain at a vertex or fragment, from the tiles whose samples are about as large
// as the pixel. Gradients blend between levels, as in a mipmap, and a tile that has just been read
// fades in. Follows relevoTerrainTiles.glsl.

#ifdef RELEVO_GLOBE
uniform float relevoUnit;     // metres per unit of height
uniform float relevoPole;     // cosine of the latitude one sample away from a pole
#else
uniform vec4 relevoGradients; // world derivatives of the derivatives by column and by row
#endif
uniform sampler2DArray relevoTileGradients;

// The result: heights per world unit, without exaggeration; on a globe to the east and the north.
vec2 relevoGradient = vec2(0.0);

// `detail` is the logarithm of the samples that the pixel covers, per side.
void relevoFindGradient(float detail)
{
  vec2 gradient = vec2(0.0); // by column and row
  float rest = 1.0;          // the weight of coarser levels
  int level = relevoFirstLevel(detail);
  do
  {
    vec2 vertex;
    ivec2 tile = relevoLocate(level, relevoRasterVSOutput, vertex);
    float visibility;
    int layer = relevoFindTile(RelevoHeights, level, tile, visibility);
    if (layer >= 0)
    {
      vec2 found = textureLod(relevoTileGradients, relevoLayerPoint(vertex, layer), 0.0).rg;
      float weight = rest * relevoLevelWeight(level, detail, visibility);
      gradient += weight * relevoPower(-level) * found;
      rest -= weight;
    }
    ++level;
  } while (level <= relevoHeightLevels.y && rest > 0.0);
#ifdef RELEVO_GLOBE
  // There is no east at the poles. Differences by column do not vanish there, because they are linear
  // in the cell at the pole.
  float cosine = length(relevoUpVSOutput.xy) / length(relevoUpVSOutput);
  float cell = relevoPole * exp2(clamp(detail, 0.0, float(relevoHeightLevels.y)));
  relevoGradient = relevoUnit *
    vec2(dot(gradient, relevoDerivativesVSOutput.xy) / max(cosine, cell),
      dot(gradient, relevoDerivativesVSOutput.zw));
#else
  relevoGradient = gradient.x * relevoGradients.xy + gradient.y * relevoGradients.zw;
#endif
}

#ifdef RELEVO_SOLID
// Return the normal of a wall or of the bottom: east, north and up, or x, y and z on a map.
vec3 relevoSideNormal()
{
  if (relevoSideVSOutput == RELEVO_BOTTOM)
  {
    return vec3(0.0, 0.0, -1.0);
  }
  int direction = relevoSideVSOutput - 1;
  vec2 outward = vec2(direction % 3, direction / 3) - vec2(1.0); // by column and row
#ifdef RELEVO_GLOBE
  float cosine = max(length(relevoUpVSOutput.xy) / length(relevoUpVSOutput), 1e-6);
  vec2 horizontal = vec2(dot(outward, relevoDerivativesVSOutput.xy) / cosine,
    dot(outward, relevoDerivativesVSOutput.zw));
#else
  vec2 horizontal = outward.x * relevoGradients.xy + outward.y * relevoGradients.zw;
#endif
  return vec3(normalize(horizontal), 0.0);
}
#endif

#ifdef RELEVO_NORMALS
uniform float relevoExaggeration;

// Return the normal in model coordinates.
vec3 relevoTerrainNormal()
{
  vec3 normal = vec3(-relevoExaggeration * relevoGradient, 1.0);
#ifdef RELEVO_SOLID
  if (relevoSideVSOutput != 0)
  {
    normal = relevoSideNormal();
  }
#endif
#ifdef RELEVO_GLOBE
  vec3 up = normalize(relevoUpVSOutput);
  vec3 east = vec3(-up.y, up.x, 0.0) / max(length(up.xy), 1e-6);
  normal = normal.z * up + normal.x * east + normal.y * cross(up, east);
#endif
  return normal;
}

#ifdef RELEVO_GLOBE
#ifndef RELEVO_CAMERA_PARALLEL
uniform int cameraParallel; // VTK's
#endif
bool relevoIsFront = true;

// OpenGL rounds vertices to fractions of a pixel, which turns some slivers at the poles around. If
// the normal points to the viewer, the fragment is of the upper side.
void relevoFindFacing()
{
  vec3 normal = normalMatrix * relevoTerrainNormal();
  float towards = cameraParallel != 0 ? normal.z : -dot(normal, vertexVCVSOutput.xyz);
  relevoIsFront = gl_FrontFacing || towards > 0.0;
}
#endif
#endif
