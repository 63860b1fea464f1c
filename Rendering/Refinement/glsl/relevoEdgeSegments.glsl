// Into how many segments the edges of a face are cut, and points on its border moved to where these
// begin and end.

uniform usamplerBuffer relevoEdgeSegments; // see RefinementEdgeSegments.h

// The segments of the sorted edges (0,1), (1,2), (0,2).
ivec3 relevoSegmentsOfFace(int face)
{
  uint texel = texelFetch(relevoEdgeSegments, face).r;
  return ivec3(int(texel & 255u), int(texel >> 8 & 255u), int(texel >> 16 & 255u));
}

// Whether the sorted corners run against the cell's sense.
bool relevoIsTurned(int face)
{
  return texelFetch(relevoEdgeSegments, face).r >> 24 != 0u;
}

// k / n to 24 bits, as patterns have it (PatternBorder.h): in integers, because GLSL leaves the
// last bits of a quotient open. That of n - k is exactly one less that of k.
float relevoSegmentEnd(int k, int n)
{
  uint weight = ((uint(k) << 24) + uint(n) / 2u) / uint(n);
  return float(weight) * 5.9604644775390625e-8; // 2^-24
}

// The weights of an edge's two corners at the end of a segment that is nearest to weight t of the
// second one. Of two as near it is the one nearer to a corner, so that no triangle turns over. They
// are the same bits whatever t was, and from both ends of the edge.
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
