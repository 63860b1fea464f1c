// Intersects a ray with the surface of a tile, in steps to the border of a cone in which the ray
// meets the surface at most once (F. Policarpo, M. Oliveira, "Relaxed Cone Stepping for Relief
// Mapping", 2007). The cones apply to rays that go away from the relief's viewer.
uniform sampler2D reliefCones;

bool reliefMeetTile()
{
  if (reliefDirection.z <= 0.0)
  {
    return reliefMeetTileLinearly();
  }
  float along = max(length(reliefDirection.xy), 1e-6);
  float before = reliefRange.x;
  float first = reliefHeightBelow(before);
  for (int i = 0; i < 64 && before < reliefRange.y; ++i)
  {
    vec2 place = (reliefOrigin + before * reliefDirection).xy - reliefBox.xy;
    ivec2 texel = reliefTile.yz + clamp(ivec2(place + 0.5), 0, RELIEF_SIZE);
    float code = min(texelFetch(reliefCones, texel, 0).r, 0.99);
    float ratio = code / (1.0 - code);
    // Below the surface, where it is open, steps are uniform.
    float size = first < 0.0 ? -ratio * first / (along + ratio * reliefDirection.z) : 0.0;
    size = clamp(size, 0.25 / max(along, reliefDirection.z), float(RELIEF_CONE_RADIUS) / along);
    float after = min(before + size, reliefRange.y);
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
