// Finds the tiles of a point. Follows the declaration of relevoOrigin.
//
// Loops over levels test their condition at the end, because Mesa's software renderer executes one
// more iteration, without effect, of a loop that tests it at the start. After such a loop, only sums
// over its iterations may be used: other variables can have the values of the pixel that left the
// loop last. The search for a tile has no such sum, and tests its condition at the start.

uniform usamplerBuffer relevoTileTable; // a hash table: key, layer and visibility
uniform int relevoTableBits;
uniform ivec2 relevoHeightLevels; // the finest and the coarsest one

const int RelevoImagery = 0; // kinds of tiles
const int RelevoHeights = 1;

// Return a power of 2.
float relevoPower(int exponent)
{
  return intBitsToFloat((exponent + 127) << 23);
}

// Find the tile of a level that contains a point (as relevoRaster), and the point in its vertices.
ivec2 relevoLocate(int level, vec2 raster, out vec2 vertex)
{
  ivec2 origin = relevoOrigin >> -RELEVO_FINEST_LEVEL; // samples
  int shift = level + RELEVO_TILE_SHIFT;
  int coarser = max(shift, 0);
  ivec2 first = (origin >> coarser) << max(-shift, 0);
  vec2 place =
    (vec2(origin & ivec2((1 << coarser) - 1)) + raster) * relevoPower(-shift);
  place = max(place, -vec2(first)); // rounding errors at the first column and row
  vec2 tile = floor(place);
  vertex = (place - tile) * float(1 << RELEVO_TILE_SHIFT);
  return first + ivec2(tile);
}

// Return the level of a number, within limits. Numbers that are not finite must not be converted to
// integers, because the result is undefined and the loops over levels might not end.
int relevoLimitLevel(float level, ivec2 limits)
{
  return level > float(limits.x) ? int(min(floor(level), float(limits.y))) : limits.x;
}

int relevoHeightLayer; // of the heights of the tile that was found last

// Return the layer of a tile, or -1.
int relevoFindTile(int kind, int level, ivec2 tile, out float visibility)
{
  uvec2 key = uvec2(tile) | uvec2(uint(kind) << 31, uint(level - RELEVO_FINEST_TILE + 1) << 26);
  uvec2 factors = uvec2(2654435769u, 2246822519u) * key;
  int last = (1 << relevoTableBits) - 1;
  int entry = int((factors.x ^ factors.y) >> (32 - relevoTableBits));
  uvec4 found = texelFetch(relevoTileTable, entry);
  while (found.xy != key && found.y != 0u)
  {
    entry = (entry + 1) & last;
    found = texelFetch(relevoTileTable, entry);
  }
  visibility = float(found.w) / 65535.0;
  relevoHeightLayer = int(found.z >> 16);
  return found.xy == key ? int(found.z & 65535u) : -1;
}

// Return the texture coordinates of a vertex of a tile in a layer.
vec3 relevoLayerPoint(vec2 vertex, int layer)
{
  return vec3((vertex + 1.5) * (1.0 / float((1 << RELEVO_TILE_SHIFT) + 3)), float(layer));
}

// Tiles blend between levels, as in a mipmap, but only within a quarter of the step between them, so
// that most pixels need one level. `detail` is the logarithm of the samples that the pixel covers,
// per side.
const float relevoSharpness = 4.0;
const float relevoMiddle = 0.6; // from a level to the place where the next one has the same weight

int relevoFirstLevel(float detail)
{
  return relevoLimitLevel(detail + (1.0 - relevoMiddle - 0.5 / relevoSharpness),
    ivec2(0, relevoHeightLevels.y));
}

// Return the part of the remaining weight that a level of heights takes. Finer levels have taken
// theirs; the coarsest level takes the rest.
float relevoLevelWeight(int level, float detail, float visibility)
{
  float weight = clamp(0.5 + relevoSharpness * (float(level) + relevoMiddle - detail), 0.0, 1.0);
  return level == relevoHeightLevels.y ? 1.0 : visibility * weight;
}
