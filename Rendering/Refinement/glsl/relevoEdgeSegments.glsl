// Into how many segments the edges of a face are cut, and points on its border moved to where these
// begin and end.

uniform usamplerBuffer relevoEdgeSegments; // see vtkRefinementEdgeSegments.h

// Of the sorted edges (0,1), (1,2), (0,2).
ivec3 relevoSegmentsOfFace(int face)
{
  uint texel = texelFetch(relevoEdgeSegments, face).r;
  return ivec3(int(texel & 255u), int(texel >> 8 & 255u), int(texel >> 16 & 255u));
}

// The weights of an edge's two corners at the end of a segment that is nearest to weight t of the
// second one. Of two as near it is the one nearer to a corner, so that no triangle turns over. They
// are the same bits whatever t was: of n segments, point k has the weights of point n - k swapped.
vec2 relevoSnapToSegment(float t, int segments)
{
  float n = float(segments);
  float k = t < 0.5 ? ceil(t * n - 0.5) : floor(t * n + 0.5);
  float less = min(k, n - k) / n;
  return k < n - k ? vec2(1.0 - less, less) : vec2(less, 1.0 - less);
}

// Exact for powers of two, where every weight of a segment's end is a float.
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
