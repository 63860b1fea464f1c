// Selects the visible intersections of a ray and the surface.
bool reliefHit = false;
bvec2 reliefSeen = bvec2(true); // whether hits of the front and of the back are visible
int reliefToPass = 0; // number of hits to skip
float reliefPassed = -1e30; // the last hit, which two quads may share on their border

// The tolerance includes the border in both adjacent quads.
const float reliefTolerance = 1e-3;

// Accept an intersection at a distance after `start`, if it is valid.
bool reliefTake(float distance, float slope, float start, float end)
{
  if (!(distance >= -reliefTolerance && start + distance <= end + reliefTolerance &&
      start + distance >= reliefRange.x && start + distance <= reliefRange.y) ||
    !(slope > 0.0 ? reliefSeen.x : reliefSeen.y) ||
    start + distance <= reliefPassed + 2.0 * reliefTolerance)
  {
    return false;
  }
  if (reliefToPass > 0)
  {
    --reliefToPass;
    reliefPassed = start + distance;
    return false;
  }
  reliefIsFront = slope > 0.0;
  reliefPoint = reliefOrigin + (start + distance) * reliefDirection;
  reliefPlace = reliefPoint.xy - reliefBox.xy;
  return true;
}
