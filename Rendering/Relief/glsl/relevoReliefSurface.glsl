// The heights and quads of a tile; shared by all methods.
uniform usamplerBuffer reliefQuads;
uniform sampler2D reliefHeights;

// of the current tile: first column and row, smallest and largest height
vec4 reliefBox = vec4(0.0);
// index of the tile, its texels in the textures, number of hits to skip
ivec4 reliefTile = ivec4(0);

vec2 reliefPlace = vec2(0.0); // the point, in quads from the tile's corner

vec4 reliefCorners(ivec2 quad)
{
  ivec2 texel = reliefTile.yz + quad;
#ifdef GL_ARB_texture_gather
  vec2 middle = vec2(texel + 1) / vec2(textureSize(reliefHeights, 0));
  return textureGather(reliefHeights, middle).wzxy;
#else
  return vec4(texelFetch(reliefHeights, texel, 0).r,
    texelFetchOffset(reliefHeights, texel, 0, ivec2(1, 0)).r,
    texelFetchOffset(reliefHeights, texel, 0, ivec2(0, 1)).r,
    texelFetchOffset(reliefHeights, texel, 0, ivec2(1, 1)).r);
#endif
}

bool reliefIsQuad(ivec2 quad)
{
  uint rows = texelFetch(reliefQuads, reliefTile.x * (RELIEF_SIZE / 2) + quad.y / 2).r;
  return ((rows >> uint((quad.y % 2) * RELIEF_SIZE + quad.x)) & 1u) != 0u;
}

// Return the derivatives of a quad's height along columns and rows.
vec2 reliefSlopes(vec4 h, vec2 place)
{
  return vec2(mix(h.y - h.x, h.w - h.z, place.y), mix(h.z - h.x, h.w - h.y, place.x));
}
