// The height of a terrain at a fragment, from the tiles whose samples are about as large as the
// pixel, however large the triangle is. Heights blend between levels, as in a mipmap, and a
// tile that has just been read fades in. Follows relevoTerrainTiles.glsl.

uniform sampler2DArray relevoTiles; // of heights

float relevoFragmentHeight = 0.0; // the result

// Return the height at a vertex of a tile in a layer, bilinear; NaN beside missing data.
float relevoTileHeight(vec2 vertex, int layer)
{
  vec2 first = floor(vertex);
  vec2 fraction = vertex - first;
  ivec3 texel = ivec3(ivec2(first) + ivec2(1), layer);
  vec2 columns = vec2(texelFetch(relevoTiles, texel, 0).r,
    texelFetch(relevoTiles, texel + ivec3(0, 1, 0), 0).r);
  vec2 next = vec2(texelFetch(relevoTiles, texel + ivec3(1, 0, 0), 0).r,
    texelFetch(relevoTiles, texel + ivec3(1, 1, 0), 0).r);
  vec2 rows = mix(columns, next, fraction.x);
  return mix(rows.x, rows.y, fraction.y);
}

// This must run at the start of main(), for all pixels, because contour lines use derivatives of the
// height. Without a tile, the height is that of the triangle. `detail` is the logarithm of the samples
// that the pixel covers, per side.
void relevoFindHeight(float detail)
{
  float rest = 1.0; // the weight of coarser levels
  int level = relevoFirstLevel(detail);
  relevoFragmentHeight = 0.0;
  do
  {
    vec2 vertex;
    ivec2 tile = relevoLocate(level, relevoRasterVSOutput, vertex);
    float visibility;
    if (relevoFindTile(RelevoHeights, level, tile, visibility) >= 0)
    {
      float height = relevoTileHeight(vertex, relevoHeightLayer);
      float weight = rest * relevoLevelWeight(level, detail, visibility);
      weight = isnan(height) ? 0.0 : weight;
      relevoFragmentHeight += weight > 0.0 ? weight * height : 0.0;
      rest -= weight;
    }
    ++level;
  } while (level <= relevoHeightLevels.y && rest > 0.0);
  relevoFragmentHeight += rest > 0.0 ? rest * relevoHeightVSOutput : 0.0;
}
