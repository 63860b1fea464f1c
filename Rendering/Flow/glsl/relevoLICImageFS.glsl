// What the passes over the viewport share.
uniform sampler2D vectors; // as relevoLICVectorsFS.glsl makes them; zero where nothing is
uniform ivec2 size;

bool licIsMasked(ivec2 pixel)
{
  return any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size)) ||
    texelFetch(vectors, pixel, 0).w <= 0.0;
}
