// Filters for LIC images. Shaders and C++ share this source.
//
// The including file provides
//
//   float licValue(ivec2 pixel)    the image; any value outside of it
//   bool licIsMasked(ivec2 pixel)  whether the pixel is masked or outside of the image

// Sharpens edges: adds the Laplacian (of the eight neighbours) and clamps to [0, 1]. Pixels with a
// masked neighbour are not changed.
RELEVO_FUNCTION float licHighPass(ivec2 pixel)
{
  float value = licValue(pixel);
  float sum = 9.0f * value;
  bool isMasked = false;
  for (int i = 0; i < 9; ++i)
  {
    ivec2 neighbour = pixel + ivec2(i % 3 - 1, i / 3 - 1);
    if (i != 4)
    {
      isMasked = isMasked || licIsMasked(neighbour);
      sum -= licValue(neighbour);
    }
  }
  return isMasked ? value : clamp(sum, 0.0f, 1.0f);
}

// Smooths in one direction, (1, 0) or (0, 1), as half of a Gaussian of 3 x 3 pixels. Pixels with a
// masked neighbour are not changed.
RELEVO_FUNCTION float licSmooth(ivec2 pixel, ivec2 direction)
{
  float value = licValue(pixel);
  if (licIsMasked(pixel - direction) || licIsMasked(pixel + direction))
  {
    return value;
  }
  return (licValue(pixel - direction) + 5.0f * value + licValue(pixel + direction)) / 7.0f;
}
