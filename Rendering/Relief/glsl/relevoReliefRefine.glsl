// Refines the intersection of a ray and the surface of a tile between two points, by interpolated
// heights, with bisection (F. Policarpo, M. Oliveira, J. Comba, "Real-Time Relief Mapping on
// Arbitrary Polygonal Surfaces", 2005) or the secant method.

// Return how far a point of the ray is below the surface, as seen by the relief's viewer.
float reliefHeightBelow(float distance)
{
  vec3 point = reliefOrigin + distance * reliefDirection;
  vec2 place = clamp(point.xy - reliefBox.xy, 0.0, float(RELIEF_SIZE));
  vec2 size = vec2(textureSize(reliefHeights, 0));
  return point.z - textureLod(reliefHeights, (vec2(reliefTile.yz) + place + 0.5) / size, 0.0).r;
}

// Search between a point in front of the surface and one behind it, in either order.
bool reliefRefine(float before, float after, float first, float second)
{
  float slope = second - first;
  float start = before;
  float end = after;
  for (int i = 0; i < RELIEF_REFINEMENTS; ++i)
  {
#ifdef RELIEF_SECANT
    float middle = before + (after - before) * first / (first - second);
#else
    float middle = 0.5 * (before + after);
#endif
    float value = reliefHeightBelow(middle);
    bool isBefore = (value < 0.0) == (first < 0.0);
    before = isBefore ? middle : before;
    first = isBefore ? value : first;
    after = isBefore ? after : middle;
    second = isBefore ? second : value;
  }
  float hit = before + (after - before) * first / (first - second);
  vec2 place = (reliefOrigin + hit * reliefDirection).xy - reliefBox.xy;
  return reliefIsQuad(clamp(ivec2(floor(place)), 0, RELIEF_SIZE - 1)) &&
    reliefTake(hit - start, slope, start, end);
}
