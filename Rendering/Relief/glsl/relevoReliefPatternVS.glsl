// A vertex of a pattern on half of a tile, at the height of its texels.
uniform samplerBuffer reliefPlaces;
uniform samplerBuffer reliefVertices;   // weights of the corners of patterns
uniform usamplerBuffer reliefInstances; // tile << 4 | half << 3 | permutation of the corners
uniform int reliefFirstInstance;
uniform int reliefTilesPerRow;
uniform sampler2D reliefHeights;
uniform mat4 reliefToClip;

flat out vec4 reliefPlaceVSOutput;
flat out ivec4 reliefTileVSOutput;
out vec3 reliefVertexVSOutput; // in quads from the tile's corner, and the height

// Return the corners of a half, starting with the first corner of both halves.
vec2 reliefCorner(int part, int corner)
{
  return float(RELIEF_SIZE) *
    (corner == 0 ? vec2(0.0) : corner == part + 1 ? vec2(1.0)
        : part == 0 ? vec2(0.0, 1.0) : vec2(1.0, 0.0));
}

vec4 reliefPatternPosition()
{
  int instance = int(texelFetch(reliefInstances, reliefFirstInstance + gl_InstanceID).r);
  int tile = instance >> 4;
  int part = (instance >> 3) & 1;
  int first = (instance & 7) % 3;
  int second = (first + ((instance & 7) < 3 ? 1 : 2)) % 3;
  int third = 3 - first - second;
  vec3 weights = texelFetch(reliefVertices, gl_VertexID).xyz;
  vec2 place = weights.x * reliefCorner(part, first) + weights.y * reliefCorner(part, second) +
    weights.z * reliefCorner(part, third);

  vec4 box = texelFetch(reliefPlaces, tile);
  reliefPlaceVSOutput = box;
  reliefTileVSOutput = ivec4(tile, (tile % reliefTilesPerRow) * RELIEF_TEXELS,
    (tile / reliefTilesPerRow) * RELIEF_TEXELS, 0);
  ivec2 quad = min(ivec2(place), RELIEF_SIZE - 1);
  ivec2 texel = reliefTileVSOutput.yz + quad;
  vec2 share = place - vec2(quad);
  // At a whole position, the height is exactly that of the texel, as in the adjacent tile.
  float height = mix(mix(texelFetch(reliefHeights, texel, 0).r,
                       texelFetch(reliefHeights, texel + ivec2(1, 0), 0).r, share.x),
    mix(texelFetch(reliefHeights, texel + ivec2(0, 1), 0).r,
      texelFetch(reliefHeights, texel + ivec2(1), 0).r, share.x), share.y);
  reliefVertexVSOutput = vec3(place, height);
  return reliefToClip * vec4(place + box.xy, height, 1.0);
}
