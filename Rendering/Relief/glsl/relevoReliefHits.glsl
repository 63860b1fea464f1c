// Which points where a ray meets the surface are seen.
bool reliefHit = false;
bvec2 reliefSeen = bvec2(true); // whether hits of the front and of the back count
int reliefToPass; // hits
float reliefPassed = -1e30; // the last one, which two quads may have on their border

// So that what lies on a border is on both sides of it.
const float reliefTolerance = 1e-3;

// Takes a hit at a distance after `start`, if it is one.
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
