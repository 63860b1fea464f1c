// A LIC image that one pass over the viewport passes to the next.
uniform sampler2D image; // (LIC, flag as in relevoLICVectorsFS.glsl); otherwise zero
uniform ivec2 size;

bool licIsMasked(ivec2 pixel)
{
  return any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size)) ||
    texelFetch(image, pixel, 0).g <= 0.0;
}
