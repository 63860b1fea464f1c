// Geomorphing: the positions of the vertices of a nested pattern (NestedPattern.h) for the
// fractional levels of a face's edges. GLSL and C++.
//
// Positions (s, y) = 128 (w1 + w2, w2), for the weights w0, w1, w2 of the sorted corners, lie on a
// square grid: edge 01 is y = 0, edge 12 is s = 128, edge 02 is s = y. A vertex of level q, the
// level of the coarsest grid that contains it, has steps of 2^(7-q). It moves from a vertex of the
// coarser grid to its own position while its tag goes from q - 0.5, where levels are rounded up to
// q, to q + 0.5. A vertex on an edge uses the tag of this edge, with bitwise equal operations on
// all three edges. Other vertices use tags that do not depend on the vertex.

// The fraction of its path that a vertex has moved.
RELEVO_FUNCTION float morphFraction(float tag, float level)
{
  return clamp(tag - (level - 0.5f), 0.0f, 1.0f);
}

// The tag of the inner grid: the median of the edges' tags, at most 1 above the lowest.
RELEVO_FUNCTION float morphInnerTag(vec3 tags)
{
  float lowest = min(min(tags.x, tags.y), tags.z);
  float middle = max(min(tags.x, tags.y), min(max(tags.x, tags.y), tags.z));
  return min(middle, lowest + 1.0f);
}

RELEVO_FUNCTION vec2 morphSlide(vec2 origin, vec2 place, float fraction)
{
  precise vec2 way = (place - origin) * fraction;
  precise vec2 current = origin + way;
  return current;
}

// A vertex on an edge starts at its neighbour in the coarser grid, towards the lower corner.
RELEVO_FUNCTION vec2 morphOnEdge(ivec2 place, int unit, float tag, float level)
{
  ivec2 origin = place & -2 * unit;
  return morphSlide(vec2(origin), vec2(place), morphFraction(tag, level));
}

// An inner vertex starts at an inner vertex of the coarser grid and never at an edge, whose tag may
// differ.
RELEVO_FUNCTION vec2 morphInside(ivec2 place, int unit, vec3 tags, float level)
{
  int coarse = 2 * unit;
  ivec2 origin = place & -coarse;
  origin.y = clamp(origin.y, coarse, 128 - 2 * coarse);
  origin.x = clamp(origin.x, origin.y + coarse, 128 - coarse);
  return morphSlide(vec2(origin), vec2(place), morphFraction(morphInnerTag(tags), level));
}

// The three inner vertices of level 2 appear as soon as any edge has this level. They start at a
// point on the line between the midpoints of edges 01 and 02. This point moves from one midpoint to
// the other as the latter arrives, because the quadrangle next to this line changes its diagonal.
// (96, 32) starts at the midpoint of edge 12 instead, or at the position that this midpoint would
// have.
RELEVO_FUNCTION vec2 morphFirstInside(ivec2 place, vec3 tags)
{
  vec3 arrived = vec3(morphFraction(tags.x, 1.0f), morphFraction(tags.y, 1.0f),
    morphFraction(tags.z, 1.0f));
  vec2 middle01 = vec2(64.0f * arrived.x, 0.0f);
  vec2 middle12 = vec2(128.0f, 64.0f * arrived.y);
  vec2 middle02 = vec2(64.0f * arrived.z);
  vec2 origin = middle02;
  if (arrived.z < arrived.x)
  {
    origin = morphSlide(middle01, middle02, arrived.z / arrived.x);
  }
  float fraction = morphFraction(max(max(tags.x, tags.y), tags.z), 2.0f);
  vec2 current = morphSlide(origin, vec2(place), fraction);
  return place.x == 96 && place.y == 32 ? morphSlide(middle12, current, fraction) : current;
}

// Weights of the sorted corners at a vertex of a nested pattern. `vertex` has the pattern's exact
// weights. `tags` are the results of morphTag() for the edges 01, 12 and 02.
RELEVO_FUNCTION vec3 morphWeights(vec3 vertex, vec3 tags)
{
  ivec2 place = ivec2(128.0f * vec2(vertex.y + vertex.z, vertex.z));
  int bits = place.x | place.y;
  int unit = bits & -bits; // steps of the vertex's grid
  if (unit == 0 || unit == 128)
  {
    return vertex; // a corner
  }
  float level = 7.0f - floor(log2(float(unit)) + 0.5f);

  vec2 current;
  if (place.y == 0)
  {
    current = morphOnEdge(place, unit, tags.x, level);
  }
  else if (place.x == 128)
  {
    current = morphOnEdge(place, unit, tags.y, level);
  }
  else if (place.x == place.y)
  {
    current = morphOnEdge(place, unit, tags.z, level);
  }
  else if (unit == 32)
  {
    current = morphFirstInside(place, tags);
  }
  else
  {
    current = morphInside(place, unit, tags, level);
  }
  current = 0.0078125f * current;
  precise vec3 weights = vec3(1.0f - current.x, current.x - current.y, current.y);
  return weights;
}
