// What is done to a LIC image beside the convolution: one source for the shaders and C++.
//
// The including side provides
//   float licValue(ivec2 pixel)    the image; any value outside it
//   bool licIsMasked(ivec2 pixel)  whether there is no LIC at the pixel, or no image

// Edges sharpened: the pixel and its Laplacian (of its eight neighbours), within [0, 1]. Where a
// neighbour is masked the pixel stays.
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

// Smoothed in one direction, (1, 0) or (0, 1): one half of a Gaussian of 3 x 3 pixels. Where a
// neighbour is masked the pixel stays.
RELEVO_FUNCTION float licSmooth(ivec2 pixel, ivec2 direction)
{
  float value = licValue(pixel);
  if (licIsMasked(pixel - direction) || licIsMasked(pixel + direction))
  {
    return value;
  }
  return (licValue(pixel - direction) + 5.0f * value + licValue(pixel + direction)) / 7.0f;
}
