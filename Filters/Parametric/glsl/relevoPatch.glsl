// Rational Bezier patches of any degree: points and derivatives.
//
// Quadrilaterals are tensor products with control points in rows along u, starting at v = 0.
// Triangles have a row for each power j of v, with increasing powers of u. Bernstein polynomials
// are summed with Horner's scheme, which reads each control point once. The last step of de
// Casteljau's algorithm provides point and derivatives together (G. Farin, "Curves and Surfaces for
// CAGD", 2002).
//
// The including file provides
//
//   PATCH_VECTOR patchPoint(int i)  control point i times its weight, and the weight
//
// and may define PATCH_VECTOR as float, for points that are a single number.

#ifndef PATCH_VECTOR
#define PATCH_VECTOR vec4
#endif

const int patchUnit = 16384; // corners of sub-patches are multiples of 1 / patchUnit

struct PatchShape
{
  int First; // control point
  ivec2 Degrees;
  bool IsTriangle; // the degree is Degrees.x
};

// Unpacks two numbers: the first control point, and p | q << 4 | 256 for a triangle | bits << 9 |
// 8192 if weights differ. p and q are the degrees. There is a bit for each border that degenerates
// to a point or is not an edge of its cell.
RELEVO_FUNCTION PatchShape unpackShape(ivec2 record)
{
  PatchShape shape;
  shape.First = record.x;
  shape.Degrees = ivec2(record.y & 15, (record.y >> 4) & 15);
  shape.IsTriangle = (record.y & 256) != 0;
  return shape;
}

// Homogeneous, like the control points. In triangles, the third weight decreases as u or v
// increases.
struct PatchPoint
{
  PATCH_VECTOR Point;
  PATCH_VECTOR ByU;
  PATCH_VECTOR ByV;
};

// The two polynomials of one degree less in a row: of all points except the last, and except the
// first.
struct PatchRow
{
  PATCH_VECTOR Low;
  PATCH_VECTOR High;
};

// The polynomial of degree n + 1 is s Low + t High. s and t need not add up to 1.
RELEVO_FUNCTION PatchRow patchRow(int first, int n, float s, float t)
{
  PatchRow row;
  row.Low = PATCH_VECTOR(0.0f);
  row.High = PATCH_VECTOR(0.0f);
  PATCH_VECTOR point = patchPoint(first);
  float factor = 1.0f; // binomial coefficient times power of t
  for (int i = 0; i <= n; ++i)
  {
    row.Low = row.Low * s + point * factor;
    point = patchPoint(first + i + 1);
    row.High = row.High * s + point * factor;
    factor *= t * float(n - i) / float(i + 1);
  }
  return row;
}

RELEVO_FUNCTION PatchPoint quadrilateralPoint(PatchShape shape, vec2 uv)
{
  vec2 st = vec2(1.0f) - uv;
  int n = shape.Degrees.y - 1;
  PatchRow low; // of all rows except the last
  PatchRow high;
  low.Low = low.High = high.Low = high.High = PATCH_VECTOR(0.0f);
  float factor = 1.0f;
  float last = 0.0f; // previous factor
  for (int j = 0; j <= n + 1; ++j)
  {
    PatchRow row = patchRow(shape.First + j * (shape.Degrees.x + 1), shape.Degrees.x - 1, st.x, uv.x);
    if (j <= n)
    {
      low.Low = low.Low * st.y + row.Low * factor;
      low.High = low.High * st.y + row.High * factor;
    }
    if (j > 0)
    {
      high.Low = high.Low * st.y + row.Low * last;
      high.High = high.High * st.y + row.High * last;
    }
    last = factor;
    factor *= uv.y * float(n - j) / float(j + 1);
  }
  PatchPoint point;
  PATCH_VECTOR atLow = low.Low * st.x + low.High * uv.x;
  PATCH_VECTOR atHigh = high.Low * st.x + high.High * uv.x;
  point.Point = atLow * st.y + atHigh * uv.y;
  point.ByU = ((low.High - low.Low) * st.y + (high.High - high.Low) * uv.y) * float(shape.Degrees.x);
  point.ByV = (atHigh - atLow) * float(shape.Degrees.y);
  return point;
}

RELEVO_FUNCTION PatchPoint trianglePoint(PatchShape shape, vec2 uv)
{
  float w = 1.0f - uv.x - uv.y;
  int n = shape.Degrees.x - 1;
  PATCH_VECTOR byU = PATCH_VECTOR(0.0f); // polynomials of one degree less, towards each corner
  PATCH_VECTOR byV = PATCH_VECTOR(0.0f);
  PATCH_VECTOR byW = PATCH_VECTOR(0.0f);
  int first = shape.First;
  float factor = 1.0f;
  float last = 0.0f;
  for (int j = 0; j <= n; ++j)
  {
    PatchRow row = patchRow(first, n - j, w, uv.x);
    byW += row.Low * factor;
    byU += row.High * factor;
    byV += (row.Low * w + row.High * uv.x) * last;
    first += n - j + 2;
    last = factor;
    factor *= uv.y * float(n - j) / float(j + 1);
  }
  byV += patchPoint(first) * last;
  PatchPoint point;
  point.Point = byW * w + byU * uv.x + byV * uv.y;
  point.ByU = (byU - byW) * float(n + 1);
  point.ByV = (byV - byW) * float(n + 1);
  return point;
}

RELEVO_FUNCTION PatchPoint patchPointAt(PatchShape shape, vec2 uv)
{
  if (shape.IsTriangle)
  {
    return trianglePoint(shape, uv);
  }
  return quadrilateralPoint(shape, uv);
}

// Evaluates the point only, which is faster.
RELEVO_FUNCTION PATCH_VECTOR patchValueAt(PatchShape shape, vec2 uv)
{
  float s = 1.0f - uv.x - (shape.IsTriangle ? uv.y : 0.0f);
  float t = shape.IsTriangle ? 1.0f : 1.0f - uv.y; // rows of a triangle contain all powers of it
  int rows = shape.IsTriangle ? shape.Degrees.x : shape.Degrees.y;
  int n = shape.Degrees.x;
  int i = shape.First;
  PATCH_VECTOR sum = PATCH_VECTOR(0.0f);
  float factor = 1.0f;
  for (int j = 0; j <= rows; ++j)
  {
    PATCH_VECTOR row = PATCH_VECTOR(0.0f);
    float along = 1.0f;
    for (int k = 0; k <= n; ++k)
    {
      row = row * s + patchPoint(i) * along;
      along *= uv.x * float(n - k) / float(k + 1);
      ++i;
    }
    sum = sum * t + row * factor;
    factor *= uv.y * float(rows - j) / float(j + 1);
    n -= shape.IsTriangle ? 1 : 0;
  }
  return sum;
}

// Control points along a border. Point k is First + k Step + k (k - 1) / 2 Growth.
struct PatchBorder
{
  int Degree;
  int First;
  int Step;
  int Growth;
};

// Returns the border that contains both corners of a sub-patch, or -1. Borders are 0: v = 0; 1: u =
// 0; 2: v = 1 or, for a triangle, u + v = 1; 3: u = 1.
RELEVO_FUNCTION int findPatchBorder(PatchShape shape, ivec2 a, ivec2 b)
{
  if (a.y == 0 && b.y == 0)
  {
    return 0;
  }
  if (a.x == 0 && b.x == 0)
  {
    return 1;
  }
  if (shape.IsTriangle)
  {
    return a.x + a.y == patchUnit && b.x + b.y == patchUnit ? 2 : -1;
  }
  if (a.y == patchUnit && b.y == patchUnit)
  {
    return 2;
  }
  return a.x == patchUnit && b.x == patchUnit ? 3 : -1;
}

RELEVO_FUNCTION PatchBorder patchBorder(PatchShape shape, int border)
{
  int p = shape.Degrees.x;
  int q = shape.Degrees.y;
  bool alongU = border == 0 || (border == 2 && !shape.IsTriangle);
  PatchBorder points;
  points.Degree = alongU ? p : q;
  points.First = shape.First;
  points.Step = alongU ? 1 : p + 1;
  points.Growth = shape.IsTriangle && !alongU ? -1 : 0;
  if (border == 2)
  {
    points.First += shape.IsTriangle ? p : q * (p + 1);
    points.Step -= shape.IsTriangle ? 1 : 0;
  }
  else if (border == 3)
  {
    points.First += p;
  }
  return points;
}

// Returns the parameter along a border, in the order of its control points.
RELEVO_FUNCTION int alongPatchBorder(PatchShape shape, int border, ivec2 corner)
{
  return border == 0 || (border == 2 && !shape.IsTriangle) ? corner.x : corner.y;
}

RELEVO_FUNCTION int patchBorderPoint(PatchBorder border, int k)
{
  return border.First + k * border.Step + k * (k - 1) / 2 * border.Growth;
}

// Evaluates a border at t, from its end if reversed. The result is bitwise identical for all
// patches that share the curve in either direction.
RELEVO_FUNCTION PATCH_VECTOR patchBorderPointAt(PatchBorder border, bool isReversed, float t)
{
  float s = 1.0f - t;
  precise PATCH_VECTOR sum = PATCH_VECTOR(0.0f);
  precise float factor = 1.0f;
  for (int i = 0; i <= border.Degree; ++i)
  {
    sum = sum * s;
    sum += patchPoint(patchBorderPoint(border, isReversed ? border.Degree - i : i)) * factor;
    factor = factor * t;
    factor = factor * float(border.Degree - i) / float(i + 1);
  }
  return sum;
}
