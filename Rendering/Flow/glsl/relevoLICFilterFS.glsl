// One filter of the LIC image.
uniform sampler2D image;
uniform sampler2D range;   // least and largest value
uniform vec2 factors;
uniform ivec2 direction;   // of smoothing
uniform int which;         // 0 high pass, 1 smoothing, 2 contrast

float licValue(ivec2 pixel)
{
  return texelFetch(image, pixel, 0).r;
}
