// Average intensity: the mean scalar along the ray, and its opacity.

Scalars mean;
float seenLength;
#if RELEVO_TABLES
Scalars meanSteepness;
#endif

void beginRay()
{
  collected = vec4(0.0);
  mean = Scalars(0.0);
  seenLength = 0.0;
#if RELEVO_TABLES
  meanSteepness = Scalars(0.0);
#endif
}

bool collect(Scalars front, Scalars back, float span, inout float from)
{
  seenLength += span;
  if (seenLength > 0.0)
  {
    float share = span / seenLength;
    mean += share * (0.5 * (front + back) - mean);
#if RELEVO_TABLES
    meanSteepness += share * (partSteepness - meanSteepness);
#endif
  }
  return true;
}

vec4 finishRay()
{
  if (!(seenLength > 0.0))
  {
    return vec4(0.0);
  }
#if RELEVO_TABLES
  findRows(meanSteepness);
#endif
  vec4 color = mapScalars(mean);
  return vec4(color.rgb * color.a, color.a);
}
