// The LIC on the surface's own fragments.
uniform sampler2D relevoLICImage;
uniform sampler2D relevoLICVectors; // as relevoLICVectorsFS.glsl makes them; zero where nothing is
uniform ivec2 relevoLICOrigin;      // lower left corner of the viewport, in pixels
uniform ivec2 relevoLICSize;        // and its size
uniform vec3 relevoLICMaskColor;
uniform float relevoLICMaskIntensity;
#ifdef RELEVO_LIC_STRETCH
uniform sampler2D relevoLICRange;   // of lightness
uniform vec2 relevoLICFactors;
#endif

const ivec2 relevoLICSteps[5] =
  ivec2[5](ivec2(0), ivec2(1, 0), ivec2(0, 1), ivec2(-1, 0), ivec2(0, -1));

// Where the fragment's LIC is: its pixel or, where it covers only part of that, the one beside it
// that is nearest in depth.
ivec2 relevoLICPixel(float tolerance)
{
  ivec2 last = relevoLICSize - ivec2(1);
  ivec2 here = clamp(ivec2(gl_FragCoord.xy) - relevoLICOrigin, ivec2(0), last);
  ivec2 best = ivec2(-1);
  float least = tolerance;
  for (int i = 0; i < 5; ++i)
  {
    ivec2 pixel = clamp(here + relevoLICSteps[i], ivec2(0), last);
    float depth = abs(texelFetch(relevoLICVectors, pixel, 0).w) - 1.0;
    float distance = abs(depth - gl_FragCoord.z);
    if (depth >= 0.0 && distance <= least)
    {
      if (i == 0)
      {
        return pixel;
      }
      least = distance;
      best = pixel;
    }
  }
  return best;
}

vec3 relevoLICFragment(vec3 color)
{
  ivec2 pixel = relevoLICPixel(1e-5 + 2.0 * fwidth(gl_FragCoord.z));
  if (pixel.x < 0)
  {
    return color; // of a layer behind
  }
  if (texelFetch(relevoLICVectors, pixel, 0).w <= 0.0)
  {
    return mix(color, relevoLICMaskColor, relevoLICMaskIntensity);
  }
  color = relevoLICCombine(color, texelFetch(relevoLICImage, pixel, 0).r);
#ifdef RELEVO_LIC_STRETCH
  color = clamp(color, 0.0, 1.0);
  color = relevoSetLightness(color, licStretch(relevoLightness(color),
    texelFetch(relevoLICRange, ivec2(0), 0).xy, relevoLICFactors));
#endif
  return color;
}
