// Ribbons and tubes along a curve. GLSL and C++: after relevoCurve.glsl, with
//   int curveIntervals()             a power of two
//   Real3 curveStationTangent(int k)
//   Real3 curveStationNormal(int k)
// A frame that does not turn about the tangent can only be followed along the curve (W. Wang, B.
// Juttler, D. Zheng, Y. Liu, "Computation of Rotation Minimizing Frames", ACM Transactions on
// Graphics 27(1), 2008). Where it has been followed to, at stations t = k / curveIntervals(), k = 0
// to curveIntervals(), it is given (CurveFrames.h); between, those on both sides are turned the
// shortest way and mixed. Curves that are joined have the same station there, to the bit.

RELEVO_FUNCTION Real3 curvePerpendicular(Real3 v, Real3 tangent)
{
  return normalize(v - dot(v, tangent) * tangent);
}

// A vector across the unit vector `from`, turned as `from` is when it becomes `to`.
RELEVO_FUNCTION Real3 curveTurn(Real3 v, Real3 from, Real3 to)
{
  Real cosine = Real(1) + dot(from, to);
  // Turned right round, it is across as it is.
  Real3 turned = cosine > Real(1e-3) ? v - (dot(v, to) / cosine) * (from + to) : v;
  return curvePerpendicular(turned, to);
}

// The direction that ribbons and tubes are across to: where curves meet, the mean of both.
RELEVO_FUNCTION Real3 curveFrameTangent(CurveLine line, Real t)
{
  if (t == Real(0) || t == Real(1))
  {
    return curveStationTangent(t == Real(0) ? 0 : curveIntervals());
  }
  return curveTangent(line, t);
}

// Across the frame's tangent, of length 1.
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

// From the middle to the side of a ribbon that is seen in its whole width from where `toEye` leads
// to, of any length; by the frame's normal where one looks along the curve.
RELEVO_FUNCTION Real3 ribbonSide(Real3 tangent, Real3 normal, Real3 toEye)
{
  Real3 side = cross(tangent, toEye);
  Real squared = dot(side, side);
  return squared > Real(1e-10) * dot(toEye, toEye) ? side / sqrt(squared)
                                                   : cross(tangent, normal);
}

// The ribbon's own normal, towards the eye.
RELEVO_FUNCTION Real3 ribbonNormal(Real3 tangent, Real3 side)
{
  return cross(side, tangent);
}

// From the middle outwards; `angle` is the cosine and the sine of where around the tube.
RELEVO_FUNCTION Real3 tubeDirection(Real3 tangent, Real3 normal, Real2 angle)
{
  precise Real3 direction = normal * angle.x + cross(tangent, normal) * angle.y;
  return direction;
}

// The normal of a tube whose radius changes by `slope` per length.
RELEVO_FUNCTION Real3 tubeNormal(Real3 tangent, Real3 direction, Real slope)
{
  return normalize(direction - slope * tangent);
}
