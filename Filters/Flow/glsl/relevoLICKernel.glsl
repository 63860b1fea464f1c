// The weights of line integral convolution along a streamline, in an image or on a surface. GLSL and
// C++.

struct LICKernel
{
  int Steps;       // each way
  float StepSize;  // length of a step; where vectors are not normalised, of a vector of length 1
  bool Normalized; // whether all vectors count as of length 1
  bool Oriented;   // weights rise upstream: what flows down from a dot grows brighter to its head
  float Phase;     // in [0, 1): how far the pattern has moved down the flow, in periods
};

// Weight of the sample k steps downstream, under a box of 2 Steps + 1 samples around a centre.
RELEVO_FUNCTION float licWindow(float k, float centre, LICKernel kernel)
{
  float edge = float(kernel.Steps) + 1.0f;
  float weight = clamp(edge - abs(k - centre), 0.0f, 1.0f);
  return kernel.Oriented ? weight * clamp(0.5f - 0.5f * (k - centre) / edge, 0.0f, 1.0f) : weight;
}

// How many steps the pattern moves as the phase grows by 1: one and a half times the length of the
// box. With less, the boxes of licWeight would touch and their pattern fade rather than move.
RELEVO_FUNCTION int licPeriod(LICKernel kernel)
{
  return 3 * kernel.Steps + 1;
}

// The weights of the box that goes and of the one that comes: of one power, and changing evenly.
RELEVO_FUNCTION vec2 licFade(LICKernel kernel)
{
  float angle = 1.57079633f * kernel.Phase;
  return vec2(cos(angle), sin(angle));
}

// Weight of the sample k steps downstream. Two boxes, one period apart, slide upstream with the
// phase, whence the pattern moves downstream, and fade into each other: phase 1 looks like phase 0,
// which is one box around the pixel.
RELEVO_FUNCTION float licWeight(float k, LICKernel kernel)
{
  float period = float(licPeriod(kernel));
  float shift = kernel.Phase * period;
  vec2 windows =
    vec2(licWindow(k, -shift, kernel), licWindow(k, period - shift, kernel));
  return dot(licFade(kernel), windows);
}

// How many steps have a weight upstream, and downstream.
RELEVO_FUNCTION ivec2 licReach(LICKernel kernel)
{
  int period = licPeriod(kernel);
  float shift = kernel.Phase * float(period);
  int upstream = kernel.Steps + int(ceil(shift));
  int downstream = kernel.Steps + (kernel.Phase > 0.0f ? period - int(floor(shift)) : 0);
  return ivec2(upstream, downstream);
}

// The contrast that the two boxes lose in their mean given back to a convolved value: what is random
// about the mean of the noise becomes as strong as at phase 0.
RELEVO_FUNCTION float licRestoreContrast(float value, float mean, LICKernel kernel)
{
  vec2 fade = licFade(kernel);
  float restored = clamp(mean + (value - mean) * (fade.x + fade.y), 0.0f, 1.0f);
  return kernel.Phase > 0.0f ? restored : value;
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
