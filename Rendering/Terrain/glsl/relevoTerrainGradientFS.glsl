// The gradient of a terrain at a fragment, from the tiles whose samples are about as large as the
// pixel. Gradients are linear between levels, as in a mipmap, and a tile that has just been read
// fades in.

uniform ivec2 relevoOrigin;  // units of the finest lattice
uniform vec4 relevoGradients; // world derivatives of the derivatives by column and by row
uniform sampler2DArray relevoTileGradients;
uniform usamplerBuffer relevoTileTable; // a hash table: key, layer and visibility
uniform int relevoTableBits;
uniform int relevoCoarsestLevel;

float relevoLevel = 0.0;          // logarithm of the samples that the pixel covers, per side
vec2 relevoGradient = vec2(0.0);  // the result: heights per world unit, without exaggeration

// This must run at the start of main(), for all pixels, because it uses derivatives.
void relevoMeasureFootprint()
{
  vec2 right = dFdx(relevoRasterVSOutput);
  vec2 up = dFdy(relevoRasterVSOutput);
  relevoLevel = 0.5 * log2(max(abs(right.x * up.y - right.y * up.x), 1e-30));
}

// Return the layer of a tile, or -1.
int relevoFindTile(int level, ivec2 tile, out float visibility)
{
  uint key = uint(level << 26 | tile.y << 13 | tile.x) + 1u;
  int last = (1 << relevoTableBits) - 1;
  int entry = int((key * 2654435769u) >> (32 - relevoTableBits));
  uvec2 found = texelFetch(relevoTileTable, entry).rg;
  while (found.x != key && found.x != 0u)
  {
    entry = (entry + 1) & last;
    found = texelFetch(relevoTileTable, entry).rg;
  }
  visibility = float(found.y >> 16) / 65535.0;
  return found.x == key ? int(found.y & 65535u) : -1;
}

void relevoFindGradient()
{
  ivec2 origin = relevoOrigin >> -RELEVO_FINEST_LEVEL; // samples
  vec2 gradient = vec2(0.0); // by column and row
  float rest = 1.0;          // the weight of coarser levels
  int level = clamp(int(floor(relevoLevel)), 0, relevoCoarsestLevel);
  while (level <= relevoCoarsestLevel && rest > 0.0)
  {
    int shift = level + RELEVO_TILE_SHIFT;
    ivec2 first = origin >> shift;
    vec2 place = (vec2(origin - (first << shift)) + relevoRasterVSOutput) / float(1 << shift);
    place = max(place, -vec2(first)); // rounding errors at the first column and row
    vec2 tile = floor(place);
    float visibility;
    int layer = relevoFindTile(level, first + ivec2(tile), visibility);
    if (layer >= 0)
    {
      vec2 vertex = (place - tile) * float(1 << RELEVO_TILE_SHIFT);
      vec2 found = textureLod(relevoTileGradients,
        vec3((vertex + 1.5) / float((1 << RELEVO_TILE_SHIFT) + 3), float(layer)), 0.0).rg;
      float weight = rest * visibility * clamp(float(level + 1) - relevoLevel, 0.0, 1.0);
      weight = level == relevoCoarsestLevel ? rest : weight;
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
