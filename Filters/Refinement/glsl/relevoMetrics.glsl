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

// Levels that cut a length into segments of `reference`: the logarithm of the tessellation level
// max(1, length / reference) (Nellmeldin 2013, eq. 2).
RELEVO_FUNCTION float lengthLevel(float length, float reference, int maximumLevel)
{
  return length > reference ? min(log2(length / reference), float(maximumLevel)) : 0.0f;
}

// Rises from 0 where a normal points to the eye (or away from it) to maximumLevel where it is
// perpendicular to the view; `cosine` of the angle between the two (Nellmeldin 2013, eq. 13).
RELEVO_FUNCTION float silhouetteLevel(float cosine, int maximumLevel)
{
  return float(maximumLevel) * (1.0f - min(abs(cosine), 1.0f));
}

// maximumLevel on an edge whose triangles face the eye and away from it, falling to 0 where both
// are turned from the contour by a cosine of `width` (silhouetteness of Dyken et al. 2008).
RELEVO_FUNCTION float contourLevel(float cosine1, float cosine2, float width, int maximumLevel)
{
  bool contour = (cosine1 <= 0.0f) != (cosine2 <= 0.0f) || cosine1 == 0.0f || cosine2 == 0.0f;
  float turned = contour ? 0.0f : min(abs(cosine1), abs(cosine2));
  return float(maximumLevel) * (1.0f - min(turned / width, 1.0f));
}

// Rises with the spread of normals, in `maximumSpread`, and with how much edge-on they are seen.
RELEVO_FUNCTION float viewDependentLevel(
  float spread, float maximumSpread, float cosine, float edgeOnWeight, int maximumLevel)
{
  float edgeOn = 1.0f - min(abs(cosine), 1.0f);
  float wanted = spread / maximumSpread * (1.0f - edgeOnWeight + edgeOnWeight * edgeOn);
  return float(maximumLevel) * min(wanted, 1.0f);
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

// Levels of several metrics as one, taken in one after the other, beginning with 0 for the largest
// and the sum, and with maximumLevel for the product. The product is of the fractions of
// maximumLevel, each to the power of its weight.
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
  return weight > 0.0f && maximumLevel > 0
    ? level * pow(min(part / float(maximumLevel), 1.0f), weight)
    : level;
}
