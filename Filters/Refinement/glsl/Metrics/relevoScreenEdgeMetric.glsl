// vtkScreenEdgeDepthTagMetric. GLSL and C++, see relevoMetricView.glsl. metricParameters[9].x is 0
// to measure the edge. To measure its sphere, it is the square of the diameter in segment lengths
// for a diameter of 1 at a distance of 1 (or at any distance, for a parallel camera).
//
// For edges, metricParameters[2] to [5] are rows of the matrix to clip coordinates: x and y, which
// are in segment lengths after division by the last, and the distance beyond the near plane (1 for
// a parallel camera, which clips nothing).

// The value for spheres is the vector from the eye. The value for edges is (position on the screen,
// distance beyond the near plane, divisor), where (x, y) is not divided if the point is not beyond
// the near plane.
RELEVO_FUNCTION vec4 metricValue(vec3 x, RELEVO_UNUSED vec4 datum)
{
  if (metricParameters[9].x > 0.0f)
  {
    return vec4(metricFromEye(x), 0.0f);
  }
  vec3 offset = metricOffset(x);
  precise vec4 clip = vec4(metricRow(2, offset), metricRow(3, offset), metricRow(4, offset),
    metricRow(5, offset));
  if (clip.z > 0.0f && clip.w > 0.0f)
  {
    precise float scale = 1.0f / clip.w;
    clip.x = clip.x * scale;
    clip.y = clip.y * scale;
  }
  return clip;
}

// The intersection with the near plane of an edge from a point beyond it to a point that is not.
RELEVO_FUNCTION vec2 metricCrossing(vec4 beyond, vec4 other)
{
  precise float t = beyond.z / (beyond.z - other.z);
  precise float s = 1.0f - t;
  precise float w = s * beyond.w + t * other.w;
  precise vec2 crossing = vec2((s * beyond.w * beyond.x + t * other.x) / w,
    (s * beyond.w * beyond.y + t * other.y) / w);
  return crossing;
}

// The square of the diameter of the sphere around the edge. An eye inside the sphere is moved to
// its surface.
RELEVO_FUNCTION float metricSphere(vec3 a, vec3 b)
{
  precise vec3 d = b - a;
  precise vec3 middle = 0.5f * (a + b);
  float squared = metricDot(d, d);
  float distance = metricParameters[1].w > 0.0f ? 1.0f : max(metricDot(middle, middle), 0.25f * squared);
  precise float measure = distance > 0.0f ? metricParameters[9].x * (squared / distance) : 0.0f;
  return measure;
}

// The square of the edge's length.
RELEVO_FUNCTION float metricEdgeMeasure(vec4 a, vec4 b)
{
  if (metricParameters[9].x > 0.0f)
  {
    return metricSphere(metricXYZ(a), metricXYZ(b));
  }
  bool seesA = a.z > 0.0f && a.w > 0.0f;
  bool seesB = b.z > 0.0f && b.w > 0.0f;
  if (!seesA && !seesB)
  {
    return 0.0f;
  }
  vec2 from = vec2(a.x, a.y);
  vec2 to = vec2(b.x, b.y);
  if (!seesB)
  {
    to = metricCrossing(a, b);
  }
  else if (!seesA)
  {
    from = metricCrossing(b, a);
  }
  precise vec2 d = to - from;
  precise float squared = d.x * d.x + d.y * d.y;
  return squared;
}

// The level that splits the length into segments: the logarithm of the tessellation level max(1,
// length / length of a segment) (Nellmeldin 2013, eq. 2).
RELEVO_FUNCTION float metricTag(float measure)
{
  return min(0.5f * metricLog2(max(1.0f, measure)), metricParameters[0].w);
}
