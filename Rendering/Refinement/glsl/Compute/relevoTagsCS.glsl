// What the passes of the stage "tag" share. Followed by the metric's own functions, see
// MetricShader.h, which C++ compiles, too.

uniform vec4 metricParameters[10];

// Measures are no less than 0, so that their bits have their order. What is not a number is 0.
uint relevoMeasureBits(float measure)
{
  return floatBitsToUint(measure > 0.0 ? measure : 0.0);
}
