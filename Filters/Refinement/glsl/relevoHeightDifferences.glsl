// The gradient of any height function by finite differences. Steps do not depend on the face, so
// that both sides of an edge get the same gradient. The including code provides float
// proceduralHeight(vec3 position, vec3 normal, vec3 weights).

RELEVO_FUNCTION HeightGradient proceduralGradient(vec3 position, vec3 normal, vec3 w)
{
  // Features are assumed to be at least as wide as high, and steps must be representable as floats.
  vec3 size = abs(position);
  float span = max(0.02f * abs(relevoAmplitude), 2e-5f * max(max(size.x, size.y), size.z));
  float height = proceduralHeight(position, normal, w);
  HeightGradient gradient;
  gradient.ByPosition = vec3(proceduralHeight(position + vec3(span, 0.0f, 0.0f), normal, w) - height,
    proceduralHeight(position + vec3(0.0f, span, 0.0f), normal, w) - height,
    proceduralHeight(position + vec3(0.0f, 0.0f, span), normal, w) - height) / max(span, 1e-30f);
  const float part = 0.0009765625f;
  gradient.ByWeights = vec3(proceduralHeight(position, normal, w + vec3(part, 0.0f, 0.0f)) - height,
    proceduralHeight(position, normal, w + vec3(0.0f, part, 0.0f)) - height,
    proceduralHeight(position, normal, w + vec3(0.0f, 0.0f, part)) - height) / part;
  return gradient;
}
