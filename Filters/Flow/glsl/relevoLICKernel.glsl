// The weights of line integral convolution along a streamline, in an image or on a surface. GLSL and
// C++.

struct LICKernel
{
  int Steps;       // each way
  float StepSize;  // length of a step; where vectors are not normalised, of a vector of length 1
  bool Normalized; // whether all vectors count as of length 1
  bool Oriented;   // weights rise upstream: what flows down from a dot grows brighter to its head
  float Phase;     // in [0, 1): how far the pattern has moved down the flow, in periods of Steps
};

// Weight of the sample k steps downstream, under a box of 2 Steps + 1 samples around a centre.
RELEVO_FUNCTION float licWindow(float k, float centre, LICKernel kernel)
{
  float edge = float(kernel.Steps) + 1.0f;
  float weight = clamp(edge - abs(k - centre), 0.0f, 1.0f);
  return kernel.Oriented ? weight * clamp(0.5f - 0.5f * (k - centre) / edge, 0.0f, 1.0f) : weight;
}

// Weight of the sample k steps downstream. Two boxes, one period apart, slide upstream with the
// phase, whence the pattern moves downstream, and fade into each other: phase 1 looks like phase 0,
// which is one box around the pixel.
RELEVO_FUNCTION float licWeight(float k, LICKernel kernel)
{
  float period = float(kernel.Steps);
  float shift = kernel.Phase * period;
  return mix(licWindow(k, -shift, kernel), licWindow(k, period - shift, kernel), kernel.Phase);
}

// How many steps have a weight upstream, and downstream.
RELEVO_FUNCTION ivec2 licReach(LICKernel kernel)
{
  float shift = kernel.Phase * float(kernel.Steps);
  int upstream = kernel.Steps + int(ceil(shift));
  int downstream = kernel.Phase > 0.0f ? 2 * kernel.Steps - int(floor(shift)) : kernel.Steps;
  return ivec2(upstream, downstream);
}

// The kernel of the second pass of enhanced convolution, over the sharpened result of the first: half
// as long, and neither oriented nor moving, as its noise is already.
RELEVO_FUNCTION LICKernel licSecondKernel(LICKernel kernel)
{
  kernel.Steps = max(kernel.Steps / 2, 1);
  kernel.Oriented = false;
  kernel.Phase = 0.0f;
  return kernel;
}
