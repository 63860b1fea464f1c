// Lightness of the colours with their LIC, for its range.
uniform sampler2D colors; // and, in place of opacity, the mark of the vector that was drawn there

vec2 relevoRange(ivec2 texel)
{
  if (licIsMasked(texel))
  {
    return vec2(1e30, -1e30);
  }
#ifdef RELEVO_COLORS
  vec4 color = texelFetch(colors, texel, 0);
  vec2 lic = texelFetch(image, texel, 0).rg;
  return color.a == lic.g ? vec2(relevoLightness(relevoLICCombine(color.rgb, lic.r)))
                          : vec2(1e30, -1e30); // behind what another process has drawn
#else
  return vec2(texelFetch(image, texel, 0).r);
#endif
}
