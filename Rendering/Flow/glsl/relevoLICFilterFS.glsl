// One filter of the LIC image.
uniform sampler2D range; // least and largest value, of contrast
uniform vec2 factors;
uniform ivec2 direction; // of smoothing

float licValue(ivec2 pixel)
{
  return texelFetch(image, pixel, 0).r;
}
