// Frames of ribbons and tubes along a curve. GLSL and C++. Included after relevoCurve.glsl, with
//
//   int curveIntervals()             a power of two
//   Real3 curveStationTangent(int k)
//   Real3 curveStationNormal(int k)
//
// Rotation-minimizing frames can only be computed by following the curve (W. Wang, B. Juttler, D.
// Zheng, Y. Liu, "Computation of Rotation Minimizing Frames", ACM Transactions on Graphics 27(1),
// 2008). CurveFrames.h does so for stations t = k / curveIntervals(), k = 0 to curveIntervals(). In
// between, the frames of both stations are rotated by the smallest rotation and interpolated.
// Joined curves have bitwise identical stations at the joint.

RELEVO_FUNCTION Real3 curvePerpendicular(Real3 v, Real3 tangent)
{
  return normalize(v - dot(v, tangent) * tangent);
}

// Applies the smallest rotation from the unit vector `from` to `to` to a perpendicular vector.
RELEVO_FUNCTION Real3 curveTurn(Real3 v, Real3 from, Real3 to)
{
  Real cosine = Real(1) + dot(from, to);
  // For opposite directions, keep the perpendicular vector.
  Real3 turned = cosine > Real(1e-3) ? v - (dot(v, to) / cosine) * (from + to) : v;
  return curvePerpendicular(turned, to);
}

// Returns the axis of ribbons and tubes: the tangent, or the mean tangent where curves meet.
RELEVO_FUNCTION Real3 curveFrameTangent(CurveLine line, Real t)
{
  if (t == Real(0) || t == Real(1))
  {
    return curveStationTangent(t == Real(0) ? 0 : curveIntervals());
  }
  return curveTangent(line, t);
}

// Returns a unit vector perpendicular to the frame's tangent.
RELEVO_FUNCTION Real3 curveFrameNormal(Real3 tangent, Real t)
{
  if (t == Real(0) || t == Real(1))
  {
    return curveStationNormal(t == Real(0) ? 0 : curveIntervals());
  }
  Real place = t * Real(curveIntervals());
  int k = min(int(place), curveIntervals() - 1);
  Real3 before = curveTurn(curveStationNormal(k), curveStationTangent(k), tangent);
  Real3 after = curveTurn(curveStationNormal(k + 1), curveStationTangent(k + 1), tangent);
  Real3 sum = mix(before, after, place - Real(k));
  return dot(sum, sum) > Real(1e-6) ? normalize(sum) : before;
}

// Returns the direction from the middle of a ribbon to its side, for a ribbon that faces the eye.
// `toEye` has any length. If the ribbon is seen along the curve, the frame's normal determines the
// side.
RELEVO_FUNCTION Real3 ribbonSide(Real3 tangent, Real3 normal, Real3 toEye)
{
  Real3 side = cross(tangent, toEye);
  Real squared = dot(side, side);
  return squared > Real(1e-10) * dot(toEye, toEye) ? side / sqrt(squared)
                                                   : cross(tangent, normal);
}

// Returns the normal of a ribbon, towards the eye.
RELEVO_FUNCTION Real3 ribbonNormal(Real3 tangent, Real3 side)
{
  return cross(side, tangent);
}

// Returns the direction outwards. `angle` has cosine and sine of the angle around the tube.
RELEVO_FUNCTION Real3 tubeDirection(Real3 tangent, Real3 normal, Real2 angle)
{
  precise Real3 direction = normal * angle.x + cross(tangent, normal) * angle.y;
  return direction;
}

// Returns the normal of a tube whose radius changes by `slope` per length.
RELEVO_FUNCTION Real3 tubeNormal(Real3 tangent, Real3 direction, Real slope)
{
  return normalize(direction - slope * tangent);
}
