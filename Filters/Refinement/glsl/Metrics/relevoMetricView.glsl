// Functions shared by view-dependent metrics. GLSL and C++.
//
// The including code provides vec4 metricParameters[10], see MetricShader.h:
//   0, 1        the camera's position in the mesh's coordinates, relative to the points' origin, as
//               the sum of two floats; w of 0: the maximum level; w of 1: 1 for a parallel camera
//   2 to 4      rows: from there to a point along the world's axes, in units of the metric
//   5           unit vector opposite to the direction of a parallel camera, along the world's axes
//   6 to 8      rows: from normals of the mesh to the world's axes
//   9           additional values of the metric

#ifndef RELEVO_UNUSED
#define RELEVO_UNUSED
#endif

RELEVO_FUNCTION float metricDot(vec3 a, vec3 b)
{
  precise float sum = a.x * b.x;
  sum = sum + a.y * b.y;
  sum = sum + a.z * b.z;
  return sum;
}

RELEVO_FUNCTION vec3 metricXYZ(vec4 v)
{
  return vec3(v.x, v.y, v.z);
}

// A level in [0, maximum level], also if the measurement failed.
RELEVO_FUNCTION float metricLevel(float level)
{
  return level > 0.0f ? min(level, metricParameters[0].w) : 0.0f;
}

// The vector from the camera to a point, exact up to rounding, at any distance from the origin.
RELEVO_FUNCTION vec3 metricOffset(vec3 x)
{
  precise vec3 offset = x - metricXYZ(metricParameters[0]);
  offset = offset - metricXYZ(metricParameters[1]);
  return offset;
}

// The dot product of a row and (offset, 1).
RELEVO_FUNCTION float metricRow(int row, vec3 offset)
{
  precise float sum = metricDot(metricXYZ(metricParameters[row]), offset);
  sum = sum + metricParameters[row].w;
  return sum;
}

RELEVO_FUNCTION vec3 metricFromEye(vec3 x)
{
  vec3 offset = metricOffset(x);
  return vec3(metricRow(2, offset), metricRow(3, offset), metricRow(4, offset));
}

// Cosine of the angle between a normal of the mesh and the view; 0 at the eye or without a normal.
RELEVO_FUNCTION float metricCosine(vec3 x, vec3 meshNormal)
{
  vec3 normal = vec3(metricDot(metricXYZ(metricParameters[6]), meshNormal),
    metricDot(metricXYZ(metricParameters[7]), meshNormal),
    metricDot(metricXYZ(metricParameters[8]), meshNormal));
  vec3 toEye = metricParameters[1].w > 0.0f ? metricXYZ(metricParameters[5]) : -metricFromEye(x);
  precise float squares = metricDot(normal, normal) * metricDot(toEye, toEye);
  precise float cosine = metricDot(normal, toEye) / sqrt(squares);
  return squares > 0.0f ? cosine : 0.0f;
}

// The base-2 logarithm of a positive number, with an error of 4e-7. It is exact for powers of 2,
// monotone, and bitwise equal on all processors.
RELEVO_FUNCTION float metricLog2(float x)
{
  int bits = floatBitsToInt(x);
  precise float whole = float((bits >> 23) - 127);
  precise float t = intBitsToFloat((bits & 0x007fffff) | 0x3f800000) - 1.0f;
  precise float q = 0.063325576f - 0.015208997f * t;
  q = q * t - 0.12970354f;
  q = q * t + 0.19543628f;
  q = q * t - 0.27788779f;
  q = q * t + 0.44266644f;
  precise float fraction = t + t * (1.0f - t) * q;
  return whole + fraction;
}
