// Intersects a ray with the surface of a tile, in steps of less than a texel. Thinner features may
// be missed.
bool reliefMeetTileLinearly()
{
  float size = reliefRange.y - reliefRange.x;
  float steps = 2.0 + ceil(1.5 * size * length(reliefDirection.xy));
  float before = reliefRange.x;
  float first = reliefHeightBelow(before);
  for (float i = 1.0; i <= steps; i += 1.0)
  {
    float after = reliefRange.x + size * i / steps;
    float second = reliefHeightBelow(after);
    if ((first < 0.0) != (second < 0.0) && reliefRefine(before, after, first, second))
    {
      return true;
    }
    before = after;
    first = second;
  }
  return false;
}
