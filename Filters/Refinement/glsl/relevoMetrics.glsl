// Depth-tags from measured values: level in [0, maximumLevel]. GLSL and C++.
// A measurement that is NaN or too large gives a finite level all the same.

// Falls linearly from maximumLevel at distance 0 to 0 at `farthest` and beyond
// (Nellmeldin 2013, eq. 1).
RELEVO_FUNCTION float distanceLevel(float x, float farthest, int maximumLevel)
{
  return x < farthest ? float(maximumLevel) * (1.0f - x / farthest) : 0.0f;
}

// Rises linearly from 0 at `low` and below to maximumLevel at `high` and above.
RELEVO_FUNCTION float rangeLevel(float x, float low, float high, int maximumLevel)
{
  if (!(x > low))
  {
    return 0.0f;
  }
  return x < high ? float(maximumLevel) * ((x - low) / (high - low)) : float(maximumLevel);
}
