// Shared by the passes of the stage "tag". The metric's own functions follow, see MetricShader.h;
// C++ compiles them, too.

uniform vec4 metricParameters[10];

// Measures are at least 0, so that their bits have the same order. NaN becomes 0.
uint relevoMeasureBits(float measure)
{
  return floatBitsToUint(measure > 0.0 ? measure : 0.0);
}
