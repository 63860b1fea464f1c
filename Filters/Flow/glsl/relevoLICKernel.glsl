// The weights of line integral convolution along a streamline, in an image or on a surface. GLSL
// and C++.

struct LICKernel
{
  int Steps;       // in each direction
  float StepSize;  // length of a step; without normalization, for a vector of length 1
  bool Normalized; // whether all vectors are normalized to length 1
  bool Oriented;   // whether weights increase upstream, so that streaks get brighter downstream
  float Phase;     // in [0, 1): how far the pattern has moved downstream, in periods
};

// Returns the weight of the sample k steps downstream in a box of 2 * Steps + 1 samples around a
// centre.
RELEVO_FUNCTION float licWindow(float k, float centre, LICKernel kernel)
{
  float edge = float(kernel.Steps) + 1.0f;
  float weight = clamp(edge - abs(k - centre), 0.0f, 1.0f);
  return kernel.Oriented ? weight * clamp(0.5f - 0.5f * (k - centre) / edge, 0.0f, 1.0f) : weight;
}

// Number of steps that the pattern moves while the phase grows by 1: one and a half times the
// length of the box. With a shorter period, the boxes of licWeight() would touch, and the pattern
// would fade instead of moving.
RELEVO_FUNCTION int licPeriod(LICKernel kernel)
{
  return 3 * kernel.Steps + 1;
}

// Weights of the disappearing and the appearing box. The sum of their squares is constant.
RELEVO_FUNCTION vec2 licFade(LICKernel kernel)
{
  float angle = 1.57079633f * kernel.Phase;
  return vec2(cos(angle), sin(angle));
}

// Returns the weight of the sample k steps downstream. Two boxes, one period apart, move upstream
// with the phase, so that the pattern moves downstream, while one fades into the other. Phase 1
// equals phase 0, which is a single box around the pixel.
RELEVO_FUNCTION float licWeight(float k, LICKernel kernel)
{
  float period = float(licPeriod(kernel));
  float shift = kernel.Phase * period;
  vec2 windows =
    vec2(licWindow(k, -shift, kernel), licWindow(k, period - shift, kernel));
  return dot(licFade(kernel), windows);
}

// Number of steps with a weight, upstream and downstream.
RELEVO_FUNCTION ivec2 licReach(LICKernel kernel)
{
  int period = licPeriod(kernel);
  float shift = kernel.Phase * float(period);
  int upstream = kernel.Steps + int(ceil(shift));
  int downstream = kernel.Steps + (kernel.Phase > 0.0f ? period - int(floor(shift)) : 0);
  return ivec2(upstream, downstream);
}

// Restores the contrast that is lost by averaging the two boxes: deviations from the mean of the
// noise are scaled to their strength at phase 0.
RELEVO_FUNCTION float licRestoreContrast(float value, float mean, LICKernel kernel)
{
  vec2 fade = licFade(kernel);
  float restored = clamp(mean + (value - mean) * (fade.x + fade.y), 0.0f, 1.0f);
  return kernel.Phase > 0.0f ? restored : value;
}

// Returns the kernel for the second pass of enhanced convolution over the sharpened result of the
// first pass. It is half as long. It is neither oriented nor moving, because its input already is.
RELEVO_FUNCTION LICKernel licSecondKernel(LICKernel kernel)
{
  kernel.Steps = max(kernel.Steps / 2, 1);
  kernel.Oriented = false;
  kernel.Phase = 0.0f;
  return kernel;
}
