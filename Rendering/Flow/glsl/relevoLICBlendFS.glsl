// The lightness of the colours with their LIC, for computing its range.
uniform sampler2D colors; // alpha is the flag of the vector that was drawn there

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
                          : vec2(1e30, -1e30); // behind the surface of another process
#else
  return vec2(texelFetch(image, texel, 0).r);
#endif
}
