// A LIC image, as the passes over the viewport hand it on.
uniform sampler2D image; // (LIC, mark as of relevoLICVectorsFS.glsl); else zero
uniform ivec2 size;

bool licIsMasked(ivec2 pixel)
{
  return any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size)) ||
    texelFetch(image, pixel, 0).g <= 0.0;
}
