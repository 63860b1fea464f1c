// Barycentric weights of a face's corners, sorted by merged point. Shared by the shaders and C++.
//
// Corners are sorted so that the two ends of an edge are in the same order in all its faces. Sums
// run over the sorted corners from left to right. On an edge, the term of the opposite corner is
// exactly 0 and does not change a sum at any position. Both faces therefore compute the same bits.

// Weights of the sorted corners from a pattern vertex (u, v, w). Codes 0 to 5 are the permutations:
// the lowest bit swaps u and v, then the other two bits rotate to the left by 0, 1 or 2.
RELEVO_FUNCTION vec3 permuteWeights(vec3 uvw, int code)
{
  vec3 w = (code & 1) != 0 ? vec3(uvw.y, uvw.x, uvw.z) : uvw;
  return code >= 4 ? vec3(w.z, w.x, w.y) : (code >= 2 ? vec3(w.y, w.z, w.x) : w);
}

RELEVO_FUNCTION vec3 weightedSum(vec3 a, vec3 b, vec3 c, vec3 w)
{
  precise vec3 sum = a * w.x;
  sum += b * w.y;
  sum += c * w.z;
  return sum;
}

RELEVO_FUNCTION vec2 weightedSum(vec2 a, vec2 b, vec2 c, vec3 w)
{
  precise vec2 sum = a * w.x;
  sum += b * w.y;
  sum += c * w.z;
  return sum;
}

RELEVO_FUNCTION vec4 weightedSum(vec4 a, vec4 b, vec4 c, vec3 w)
{
  precise vec4 sum = a * w.x;
  sum += b * w.y;
  sum += c * w.z;
  return sum;
}

// The unit vector of v, or 0 if v is zero or not finite. It is scaled first, because the squares of
// small or large components are out of the range of float.
RELEVO_FUNCTION vec3 unitVector(vec3 v)
{
  float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(largest > 0.0f))
  {
    return vec3(0.0f);
  }
  vec3 scaled = v / largest;
  float squared = dot(scaled, scaled);
  return squared > 0.0f ? scaled / sqrt(squared) : vec3(0.0f);
}
