// Line integral convolution of one pixel (Cabral and Leedom, Imaging Vector Fields Using Line
// Integral Convolution, 1993). Shaders and C++ (with GLM) share this source.
//
// Positions are in pixels from the lower left corner. Pixel centres are at (i + 0.5, j + 0.5). The
// including file provides relevoLICKernel.glsl and
//
//   vec2 licField(vec2 p)   the vector at p, bilinear between centres; zero outside, and where the
//                           nearest sample (in shaders: most samples around p) is zero
//   float licNoise(vec2 p)  the noise at p
//
// Vectors shorter than 1e-18 are treated as zero. Scale fields so that the longest vector is about
// 1.

RELEVO_FUNCTION vec2 licVelocity(vec2 p, LICKernel kernel)
{
  vec2 v = licField(p);
  float speed = length(v);
  return speed > 1e-18f ? (kernel.Normalized ? v / speed : v) : vec2(0.0f);
}

// Returns the sums of weighted noise and of weights along a streamline in one direction, with the
// midpoint rule. The line ends at zero vectors, without their noise.
RELEVO_FUNCTION vec2 licWalk(vec2 start, float way, int reach, LICKernel kernel)
{
  float h = way * kernel.StepSize;
  vec2 sum = vec2(0.0f);
  vec2 p = start;
  vec2 velocity = licVelocity(p, kernel);
  for (int k = 1; k <= reach && velocity != vec2(0.0f); ++k)
  {
    vec2 middle = licVelocity(p + 0.5f * h * velocity, kernel);
    p += h * middle;
    velocity = middle == vec2(0.0f) ? middle : licVelocity(p, kernel);
    if (velocity != vec2(0.0f))
    {
      sum += licWeight(way * float(k), kernel) * vec2(licNoise(p), 1.0f);
    }
  }
  return sum;
}

// Convolves the noise along the streamline through p.
RELEVO_FUNCTION float licConvolve(vec2 p, LICKernel kernel)
{
  float noise = licNoise(p);
  ivec2 reach = licReach(kernel);
  vec2 sum = licWeight(0.0f, kernel) * vec2(noise, 1.0f) +
    licWalk(p, -1.0f, reach.x, kernel) + licWalk(p, 1.0f, reach.y, kernel);
  return sum.y > 0.0f ? sum.x / sum.y : noise;
}
