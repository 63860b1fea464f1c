// Composite blending by a table of integrals, for functions of one component.

uniform float tableSize;

#if RELEVO_PRE_INTEGRATED == 3
// The table over the scalars at the front and the back and the length contains premultiplied
// colours.
uniform sampler3D integrals;
uniform float longestPart;

vec4 fetchIntegral(float front, float back, float span)
{
  vec3 at = clamp(vec3(front, back, span / longestPart), 0.0, 1.0);
  return texture(integrals, (at * (tableSize - 1.0) + vec3(0.5)) / tableSize);
}
#else
// The table over the scalars at the front and the back contains the mean extinction, which gives
// the exact optical depth, and the mean colour times that, which is an approximation: it also
// depends on the length.
//
// S. Guthe, S. Roettger, A. Schieber, W. Strasser, T. Ertl, "High-Quality Unstructured Volume
// Rendering on the PC Platform", Graphics Hardware 2002.
uniform sampler2D integrals;
const float longestPart = 1e30;

vec4 fetchIntegral(float front, float back, float span)
{
  vec2 at = clamp(vec2(front, back), 0.0, 1.0);
  vec4 mean = texture(integrals, (at * (tableSize - 1.0) + vec2(0.5)) / tableSize);
  float depth = mean.a * span;
  float share = depth > 1e-4 ? (1.0 - exp(-depth)) / mean.a : span * (1.0 - 0.5 * depth);
  return mean * share;
}
#endif

void beginRay()
{
  collected = vec4(0.0);
}

// Segments longer than the table's are split.
bool collect(float front, float back, float span, inout float from)
{
  bool isLast = !(span * (1.0 - from) > longestPart);
  float to = isLast ? 1.0 : from + longestPart / span;
  collected = frontOverBack(collected,
    fetchIntegral(mix(front, back, from), mix(front, back, to), (to - from) * span));
  from = to;
  return isLast;
}

vec4 finishRay()
{
  return collected;
}
