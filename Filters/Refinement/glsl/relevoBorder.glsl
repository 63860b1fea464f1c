// Points on the edges of a face whose edges have segments of their own, for triangulations that are
// not made of patterns. GLSL and C++.

// Weight of the far end for point k of n of an edge: k / n to 24 bits, in integers, because GLSL
// leaves a quotient's last bits open. Exactly one less the weight of point n - k; the same as that
// of the patterns (vtkPatternBorder.h).
RELEVO_FUNCTION float borderWeight(int k, int n)
{
  uint numerator = uint(k) << 24u;
  uint far = (numerator + uint(n) / 2u) / uint(n);
  return float(far) * 5.9604644775390625e-8f;
}

// The exact weights of the sorted corners for weights that are nearly those of a point on an edge,
// or of a point inside, which stays; `segments` are those of the edges 01, 12 and 02.
RELEVO_FUNCTION vec3 snapToBorder(vec3 w, ivec3 segments)
{
  // With at most 128 segments points inside are farther off.
  const float near = 0.002f;
  if (w.z < near)
  {
    float far = borderWeight(int(w.y * float(segments.x) + 0.5f), segments.x);
    return vec3(1.0f - far, far, 0.0f);
  }
  if (w.x < near)
  {
    float far = borderWeight(int(w.z * float(segments.y) + 0.5f), segments.y);
    return vec3(0.0f, 1.0f - far, far);
  }
  if (w.y < near)
  {
    float far = borderWeight(int(w.z * float(segments.z) + 0.5f), segments.z);
    return vec3(1.0f - far, 0.0f, far);
  }
  return w;
}
