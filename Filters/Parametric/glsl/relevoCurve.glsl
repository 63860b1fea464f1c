// A rational Bezier curve of any degree: points, tangents and values. GLSL and C++: the including
// side says what Real, Real3 and Real4 are (float or double), and gives
//   int curveDegree()          1 or more
//   Real4 curvePoint(int i)    control point 0 to curveDegree(), not multiplied with its weight
// A point is found as de Casteljau's last step does, between two points on a line that touches the
// curve: two curves of one degree less, each by Horner's scheme (G. Farin, "Curves and Surfaces for
// CAGD", 5th ed., 2002, section 5.4). All is relative to the first control point, which loses no
// digits far from the origin.

// Its ends, multiplied with their weights.
struct CurveLine
{
  Real4 First;
  Real4 Last;
};

// A control point's offset from the first one, and its weight.
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

// Exactly the first and the last control point at both ends.
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

// From control point `from` to the next one in steps of `step` that is elsewhere; zero without.
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

// The direction of the curve, of length 1. Where control points coincide, that of its limit at an
// end; where it stops inside, that of its chord.
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
  // A chord that is closed leaves nothing better than where the curve begins.
  Real squared = dot(direction, direction);
  direction = squared > Real(0) ? direction : curveEndDirection(0, 1);
  return normalize(direction);
}
