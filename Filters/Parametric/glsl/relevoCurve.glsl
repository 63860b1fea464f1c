// Rational Bezier curves of any degree: points, tangents and values. GLSL and C++. The including
// file defines Real, Real3 and Real4 (float or double), and
//
//   int curveDegree()          1 or more
//   Real4 curvePoint(int i)    control point 0 to curveDegree(), not multiplied by its weight
//
// A point is computed as in the last step of de Casteljau's algorithm, between two points on a
// tangent of the curve. They are points of two curves of one degree less, evaluated with Horner's
// scheme (G. Farin, "Curves and Surfaces for CAGD", 5th ed., 2002, section 5.4). Coordinates are
// relative to the first control point, for precision far from the origin.

// The two points on the tangent, multiplied by their weights.
struct CurveLine
{
  Real4 First;
  Real4 Last;
};

// Offset of a control point from the first one, multiplied by its weight, and its weight.
RELEVO_FUNCTION Real4 curveOffset(int i)
{
  Real4 point = curvePoint(i);
  precise Real3 offset = Real3(point) - Real3(curvePoint(0));
  return Real4(offset * point.w, point.w);
}

RELEVO_FUNCTION CurveLine curveLine(Real t)
{
  int last = curveDegree() - 1;
  Real rest = Real(1) - t;
  Real power = Real(1);
  int choose = 1;
  precise Real4 first = curveOffset(0);
  Real4 next = curveOffset(1);
  precise Real4 second = next;
  for (int i = 1; i <= last; ++i)
  {
    power *= t;
    choose = choose * (last - i + 1) / i;
    Real factor = Real(choose) * power;
    first = first * rest + next * factor;
    next = curveOffset(i + 1);
    second = second * rest + next * factor;
  }
  CurveLine line;
  line.First = first;
  line.Last = second;
  return line;
}

// Returns exactly the first or last control point at the ends.
RELEVO_FUNCTION Real3 curvePosition(CurveLine line, Real t)
{
  if (t == Real(1))
  {
    return Real3(curvePoint(curveDegree()));
  }
  precise Real4 offset = line.First * (Real(1) - t) + line.Last * t;
  precise Real3 position = Real3(curvePoint(0)) + Real3(offset) / offset.w;
  return position;
}

// Returns the vector from control point `from` to the first distinct one in steps of `step`, or
// zero.
RELEVO_FUNCTION Real3 curveEndDirection(int from, int step)
{
  Real3 end = Real3(curvePoint(from));
  for (int i = 1; i <= curveDegree(); ++i)
  {
    Real3 direction = Real3(curvePoint(from + step * i)) - end;
    if (dot(direction, direction) > Real(0))
    {
      return direction;
    }
  }
  return Real3(Real(0));
}

// Returns the unit tangent. If control points coincide, this is the limit at the ends, and the
// direction of the chord at other points where the derivative vanishes.
RELEVO_FUNCTION Real3 curveTangent(CurveLine line, Real t)
{
  Real3 direction = Real3(line.Last) / line.Last.w - Real3(line.First) / line.First.w;
  if (t == Real(0))
  {
    direction = curveEndDirection(0, 1);
  }
  else if (t == Real(1))
  {
    direction = -curveEndDirection(curveDegree(), -1);
  }
  else if (dot(direction, direction) == Real(0))
  {
    direction = Real3(curvePoint(curveDegree())) - Real3(curvePoint(0));
  }
  // If the chord is closed, use the direction at the start.
  Real squared = dot(direction, direction);
  direction = squared > Real(0) ? direction : curveEndDirection(0, 1);
  return normalize(direction);
}
