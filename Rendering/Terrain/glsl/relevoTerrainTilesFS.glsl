// Finds the tiles of a fragment.

uniform ivec2 relevoOrigin; // units of the finest lattice
uniform usamplerBuffer relevoTileTable; // a hash table: key, layer and visibility
uniform int relevoTableBits;
uniform ivec2 relevoHeightLevels; // the finest and the coarsest one

const int RelevoImagery = 0; // kinds of tiles
const int RelevoHeights = 1;

vec2 relevoRight = vec2(0.0); // changes of the column and row per pixel
vec2 relevoUp = vec2(0.0);

// This must run at the start of main(), for all pixels, because it uses derivatives.
void relevoMeasureFootprint()
{
  relevoRight = dFdx(relevoRasterVSOutput);
  relevoUp = dFdy(relevoRasterVSOutput);
}

// Find the tile of a level that contains a point (as relevoRaster), and the point in its vertices.
ivec2 relevoLocate(int level, vec2 raster, out vec2 vertex)
{
  ivec2 origin = relevoOrigin >> -RELEVO_FINEST_LEVEL; // samples
  int shift = level + RELEVO_TILE_SHIFT;
  int coarser = max(shift, 0);
  int finer = max(-shift, 0);
  ivec2 first = (origin >> coarser) << finer;
  vec2 place = (vec2(origin - ((origin >> coarser) << coarser)) + raster) *
    (float(1 << finer) / float(1 << coarser));
  place = max(place, -vec2(first)); // rounding errors at the first column and row
  vec2 tile = floor(place);
  vertex = (place - tile) * float(1 << RELEVO_TILE_SHIFT);
  return first + ivec2(tile);
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
  return vec3((vertex + 1.5) / float((1 << RELEVO_TILE_SHIFT) + 3), float(layer));
}
