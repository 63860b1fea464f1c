// Lightness of the colours with their LIC, for its range.
uniform sampler2D colors;

vec2 relevoRange(ivec2 texel)
{
  if (licIsMasked(texel))
  {
    return vec2(1e30, -1e30);
  }
#ifdef RELEVO_COLORS
  vec3 color = texelFetch(colors, texel, 0).rgb;
  return vec2(relevoLightness(relevoLICCombine(color, texelFetch(image, texel, 0).r)));
#else
  return vec2(texelFetch(image, texel, 0).r);
#endif
}
