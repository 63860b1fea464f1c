// vtkDistanceDepthTagMetric. GLSL and C++, see relevoMetricView.glsl. Vectors from the eye are in
// units of the distance of level 0. metricParameters[9].x: whether the level falls with the
// projected size.

// The level at a distance, given its square: linear from the maximum level at 0 to 0 at 1 and
// beyond (Nellmeldin 2013, eq. 1), or one level less for each doubling of the distance, down to 0
// at 1.
RELEVO_FUNCTION float distanceLevel(float squared)
{
  if (!(squared < 1.0f))
  {
    return 0.0f;
  }
  return metricParameters[9].x > 0.0f ? -0.5f * metricLog2(max(squared, 1e-30f))
                                      : metricParameters[0].w * (1.0f - sqrt(squared));
}

// (level, 0, 0, 0)
RELEVO_FUNCTION vec4 metricValue(vec3 x, RELEVO_UNUSED vec4 datum)
{
  vec3 fromEye = metricFromEye(x);
  return vec4(metricLevel(distanceLevel(metricDot(fromEye, fromEye))), 0.0f, 0.0f, 0.0f);
}

RELEVO_FUNCTION float metricPointMeasure(vec4 value)
{
  return value.x;
}

// The measure of the nearer end.
RELEVO_FUNCTION float metricEdgeMeasure(vec4 a, vec4 b)
{
  return max(a.x, b.x);
}

RELEVO_FUNCTION float metricTag(float measure)
{
  return measure;
}
