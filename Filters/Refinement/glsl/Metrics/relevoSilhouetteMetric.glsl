// vtkSilhouetteDepthTagMetric with the criterion NORMAL_ANGLE. GLSL and C++, see
// relevoMetricView.glsl. datum: a normal of the mesh, and 1, or 0 if there is none.

// (level, whether it faces the eye, whether it faces away, 0). The level rises from 0, where the
// normal points towards or away from the eye, to the maximum level, where it is perpendicular to
// the view (Nellmeldin 2013, eq. 13).
RELEVO_FUNCTION vec4 metricValue(vec3 x, vec4 datum)
{
  float cosine = metricCosine(x, metricXYZ(datum));
  if (!(datum.w > 0.0f))
  {
    return vec4(0.0f);
  }
  precise float level = metricParameters[0].w * (1.0f - abs(cosine));
  return vec4(
    metricLevel(level), cosine > 0.0f ? 1.0f : 0.0f, cosine < 0.0f ? 1.0f : 0.0f, 0.0f);
}

RELEVO_FUNCTION float metricPointMeasure(vec4 value)
{
  return value.x;
}

RELEVO_FUNCTION float metricEdgeMeasure(vec4 a, vec4 b)
{
  bool turns = max(a.y, b.y) > 0.0f && max(a.z, b.z) > 0.0f;
  return turns ? metricParameters[0].w : max(a.x, b.x);
}

RELEVO_FUNCTION float metricTag(float measure)
{
  return measure;
}
