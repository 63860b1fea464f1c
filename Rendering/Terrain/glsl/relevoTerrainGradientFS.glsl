// The gradient of a terrain at a fragment, from the tiles whose samples are about as large as the
// pixel. Gradients are linear between levels, as in a mipmap, and a tile that has just been read
// fades in. Follows relevoTerrainTilesFS.glsl.

uniform vec4 relevoGradients; // world derivatives of the derivatives by column and by row
uniform sampler2DArray relevoTileGradients;
uniform ivec2 relevoGradientLevels; // the finest and the coarsest one

vec2 relevoGradient = vec2(0.0); // the result: heights per world unit, without exaggeration

void relevoFindGradient()
{
  // The logarithm of the samples that the pixel covers, per side.
  float detail = 0.5 *
    log2(max(abs(relevoRight.x * relevoUp.y - relevoRight.y * relevoUp.x), 1e-30));
  vec2 gradient = vec2(0.0); // by column and row
  float rest = 1.0;          // the weight of coarser levels
  int level = clamp(int(floor(detail)), 0, relevoGradientLevels.y);
  while (level <= relevoGradientLevels.y && rest > 0.0)
  {
    vec2 vertex;
    ivec2 tile = relevoLocate(level, relevoRasterVSOutput, vertex);
    float visibility;
    int layer = relevoFindTile(RelevoHeights, level, tile, visibility);
    if (layer >= 0)
    {
      vec2 found = textureLod(relevoTileGradients, relevoLayerPoint(vertex, layer), 0.0).rg;
      float weight = rest * visibility * clamp(float(level + 1) - detail, 0.0, 1.0);
      weight = level == relevoGradientLevels.y ? rest : weight;
      gradient += weight * found / float(1 << level);
      rest -= weight;
    }
    ++level;
  }
  relevoGradient = gradient.x * relevoGradients.xy + gradient.y * relevoGradients.zw;
}

#ifdef RELEVO_NORMALS
#ifndef RELEVO_NORMAL_MATRIX
uniform mat3 normalMatrix; // VTK's
#endif
uniform float relevoExaggeration;

vec3 relevoTerrainNormal()
{
  return normalize(normalMatrix * vec3(-relevoExaggeration * relevoGradient, 1.0));
}
#endif
