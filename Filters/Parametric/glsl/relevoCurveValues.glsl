// Point data along a curve, in the basis of the curve. GLSL and C++. Included after
// relevoCurve.glsl, with
//
//   Real4 curveValue(int i)    the value at control point i, with the weight of curvePoint(i)

// Values at the two points of curveLine(), multiplied by their weights.
struct CurveValueLine
{
  Real4 First;
  Real4 Last;
};

RELEVO_FUNCTION CurveValueLine curveValueLine(Real t)
{
  int last = curveDegree() - 1;
  Real rest = Real(1) - t;
  Real power = Real(1);
  int choose = 1;
  precise Real4 first = curveValue(0) * curvePoint(0).w;
  Real4 next = curveValue(1) * curvePoint(1).w;
  precise Real4 second = next;
  for (int i = 1; i <= last; ++i)
  {
    power *= t;
    choose = choose * (last - i + 1) / i;
    Real factor = Real(choose) * power;
    first = first * rest + next * factor;
    next = curveValue(i + 1) * curvePoint(i + 1).w;
    second = second * rest + next * factor;
  }
  CurveValueLine line;
  line.First = first;
  line.Last = second;
  return line;
}

RELEVO_FUNCTION Real4 curveValueAt(CurveLine line, CurveValueLine values, Real t)
{
  if (t == Real(0) || t == Real(1))
  {
    return curveValue(t == Real(0) ? 0 : curveDegree());
  }
  precise Real4 sum = values.First * (Real(1) - t) + values.Last * t;
  precise Real weight = line.First.w * (Real(1) - t) + line.Last.w * t;
  return sum / weight;
}

// Returns the change of values per length of the curve, or 0 where its derivative vanishes.
RELEVO_FUNCTION Real4 curveSlope(CurveLine line, CurveValueLine values)
{
  Real3 way = Real3(line.Last) / line.Last.w - Real3(line.First) / line.First.w;
  Real4 change = values.Last / line.Last.w - values.First / line.First.w;
  Real squared = dot(way, way);
  return squared > Real(0) ? change / sqrt(squared) : Real4(Real(0));
}
