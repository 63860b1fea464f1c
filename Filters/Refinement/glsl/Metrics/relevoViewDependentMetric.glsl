// vtkViewDependentDepthTagMetric. GLSL and C++, see relevoMetricView.glsl. datum: the mean normal,
// and the spread of normals divided by the maximum spread. metricParameters[9].x: EdgeOnWeight.

// (level, 0, 0, 0). The level rises with the spread of normals and towards edge-on views.
RELEVO_FUNCTION vec4 metricValue(vec3 x, vec4 datum)
{
  float edgeOn = 1.0f - min(abs(metricCosine(x, metricXYZ(datum))), 1.0f);
  float weight = metricParameters[9].x;
  precise float wanted = datum.w * (1.0f - weight + weight * edgeOn);
  return vec4(metricLevel(metricParameters[0].w * min(wanted, 1.0f)), 0.0f, 0.0f, 0.0f);
}

RELEVO_FUNCTION float metricPointMeasure(vec4 value)
{
  return value.x;
}

RELEVO_FUNCTION float metricEdgeMeasure(vec4 a, vec4 b)
{
  return max(a.x, b.x);
}

RELEVO_FUNCTION float metricTag(float measure)
{
  return measure;
}
