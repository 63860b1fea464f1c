// The number of segments of a face's edges. Points on its border are moved to the ends of segments.

uniform usamplerBuffer relevoEdgeSegments; // see RefinementEdgeSegments.h

// Return the segments of the sorted edges (0,1), (1,2), (0,2).
ivec3 relevoSegmentsOfFace(int face)
{
  uint texel = texelFetch(relevoEdgeSegments, face).r;
  return ivec3(int(texel & 255u), int(texel >> 8 & 255u), int(texel >> 16 & 255u));
}

// Return whether the order of the sorted corners is opposite to the cell's orientation.
bool relevoIsTurned(int face)
{
  return texelFetch(relevoEdgeSegments, face).r >> 24 != 0u;
}

// Return k / n to 24 bits, as in patterns (PatternBorder.h). Integers are used because GLSL does
// not define the last bits of a quotient. The result for n - k is exactly one minus that for k.
float relevoSegmentEnd(int k, int n)
{
  uint weight = ((uint(k) << 24) + uint(n) / 2u) / uint(n);
  return float(weight) * 5.9604644775390625e-8; // 2^-24
}

// Return the weights of an edge's two corners at the segment end that is nearest to weight t of the
// second corner. Of two equally near ends, the one nearer to a corner is used, so that no triangle
// flips. The result is bit-identical for all t near an end, and for both directions of the edge.
vec2 relevoSnapToSegment(float t, int segments)
{
  float n = float(segments);
  float k = t < 0.5 ? ceil(t * n - 0.5) : floor(t * n + 0.5);
  float end = relevoSegmentEnd(int(k), segments);
  return vec2(1.0 - end, end);
}

vec3 relevoSnapToSegments(vec3 w, ivec3 segments)
{
  if (w.z == 0.0)
  {
    return vec3(relevoSnapToSegment(w.y, segments.x), 0.0);
  }
  if (w.x == 0.0)
  {
    return vec3(0.0, relevoSnapToSegment(w.z, segments.y));
  }
  if (w.y == 0.0)
  {
    vec2 ends = relevoSnapToSegment(w.z, segments.z);
    return vec3(ends.x, 0.0, ends.y);
  }
  return w;
}
