// A filter of the LIC image.
uniform sampler2D range; // smallest and largest value, for the contrast
uniform vec2 factors;
uniform ivec2 direction; // direction of smoothing

float licValue(ivec2 pixel)
{
  return texelFetch(image, pixel, 0).r;
}
