// Applies the LIC to the surface's fragments.
uniform sampler2D relevoLICImage;   // (LIC, flag as in relevoLICVectorsFS.glsl); otherwise zero
uniform ivec2 relevoLICOrigin;      // lower left corner of the viewport, in pixels
uniform ivec2 relevoLICSize;        // and its size
uniform vec3 relevoLICMaskColor;
uniform float relevoLICMaskIntensity;
#ifdef RELEVO_LIC_STRETCH
uniform sampler2D relevoLICRange;   // range of lightness
uniform vec2 relevoLICFactors;
#endif

const ivec2 relevoLICSteps[4] = ivec2[4](ivec2(1, 0), ivec2(0, 1), ivec2(-1, 0), ivec2(0, -1));

// Return the difference in depth between the fragment and a texel of the LIC.
float relevoLICDistance(vec2 texel)
{
  float distance = abs(abs(texel.g) - 1.0 - gl_FragCoord.z);
  return texel.g == 0.0 ? 2.0 : distance;
}

// Return the fragment's texel at its pixel. If the fragment covers only a part of the pixel, return
// the neighbouring texel that is nearest in depth. Return zero if there is none.
vec2 relevoLICTexel(float tolerance)
{
  ivec2 last = relevoLICSize - ivec2(1);
  ivec2 here = ivec2(gl_FragCoord.xy) - relevoLICOrigin;
  vec2 best = texelFetch(relevoLICImage, clamp(here, ivec2(0), last), 0).rg;
  float least = relevoLICDistance(best);
  bool found = least <= tolerance;
  for (int i = 0; i < 4 && !found; ++i)
  {
    vec2 texel =
      texelFetch(relevoLICImage, clamp(here + relevoLICSteps[i], ivec2(0), last), 0).rg;
    float distance = relevoLICDistance(texel);
    best = distance < least ? texel : best;
    least = min(distance, least);
  }
  return least <= tolerance ? best : vec2(0.0);
}

vec3 relevoLICFragment(vec3 color)
{
  vec2 texel = relevoLICTexel(1e-5 + 2.0 * fwidth(gl_FragCoord.z));
  if (texel.g == 0.0)
  {
    return color; // a layer behind the front one
  }
  if (texel.g < 0.0)
  {
    return mix(color, relevoLICMaskColor, relevoLICMaskIntensity);
  }
  color = relevoLICCombine(color, texel.r);
#ifdef RELEVO_LIC_STRETCH
  color = clamp(color, 0.0, 1.0);
  color = relevoSetLightness(color, licStretch(relevoLightness(color),
    texelFetch(relevoLICRange, ivec2(0), 0).xy, relevoLICFactors));
#endif
  return color;
}
