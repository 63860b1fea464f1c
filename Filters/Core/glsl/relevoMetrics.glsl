// Depth-tags from measured values: levels in [0, maximumLevel]. GLSL and C++. NaN and very large
// values give finite levels too. View-dependent metrics have separate files, see
// relevoMetricView.glsl.

// Rises linearly from 0 at `low` and below to maximumLevel at `high` and above.
RELEVO_FUNCTION float rangeLevel(float x, float low, float high, int maximumLevel)
{
  if (!(x > low))
  {
    return 0.0f;
  }
  return x < high ? float(maximumLevel) * ((x - low) / (high - low)) : float(maximumLevel);
}

// The square of the cosine by which the triangles of an edge are turned away from the contour. It
// is 0 if one faces the eye and the other faces away, and at the eye itself. The heights are those
// of the eye above their planes.
RELEVO_FUNCTION float contourMeasure(float height1, float height2, float squaredDistance)
{
  float height = min(abs(height1), abs(height2));
  bool turned = height1 * height2 > 0.0f && squaredDistance > 0.0f;
  return turned ? height * height / squaredDistance : 0.0f;
}

// maximumLevel on the contour, falling to 0 at a cosine of `width` (after the silhouetteness of
// Dyken et al. 2008).
RELEVO_FUNCTION float contourLevel(float measure, float width, int maximumLevel)
{
  return float(maximumLevel) * max(0.0f, 1.0f - sqrt(measure) / width);
}

// maximumLevel inside (distance <= 0), falling smoothly to 0 at a distance of `fallOff`.
RELEVO_FUNCTION float regionLevel(float distance, float fallOff, int maximumLevel)
{
  if (distance <= 0.0f)
  {
    return float(maximumLevel);
  }
  if (!(distance < fallOff))
  {
    return 0.0f;
  }
  float t = 1.0f - distance / fallOff;
  return float(maximumLevel) * (t * t * (3.0f - 2.0f * t));
}

// Combine the levels of several metrics one by one, starting with 0 for the maximum and the sum,
// and with maximumLevel for the product. The product multiplies the fractions of maximumLevel, each
// to the power of its weight.
RELEVO_FUNCTION float largestLevel(float level, float part, float weight, int maximumLevel)
{
  return min(max(level, weight * part), float(maximumLevel));
}

RELEVO_FUNCTION float summedLevel(float level, float part, float weight, int maximumLevel)
{
  return min(level + weight * part, float(maximumLevel));
}

RELEVO_FUNCTION float multipliedLevel(float level, float part, float weight, int maximumLevel)
{
  if (!(weight > 0.0f) || maximumLevel == 0)
  {
    return level;
  }
  float fraction = min(part / float(maximumLevel), 1.0f);
  return level * (weight == 1.0f ? fraction : pow(fraction, weight));
}
