// Isosurfaces. The number of isovalues that are not above the scalar is tracked along the ray.
// Where it changes inside a cell, or between adjacent cells, the ray meets an isosurface.

uniform samplerBuffer isoValues; // in ascending order; two texels each: the value, and its colour
uniform int numberOfIsoValues;
uniform int isoComponent;
uniform int isoCurve;
uniform float isoSame; // tolerance between adjacent cells

// Scalars are from 0 to 1. In cells whose corners have one value, they deviate from it by at most
// this.
const float IsoRounding = 5e-7;
// A tolerance of depths, in radii of the mesh; closer cells are adjacent.
const float IsoTouching = 1e-5;

int isoBelow; // number of isovalues that are not above the scalar
float isoLower; // the last of them
float isoUpper; // the next isovalue
bool isIsoNew; // whether the walk has just begun
float isoScalar; // scalar at the previous position
float isoDepth;

void setIsoBelow(int below)
{
  isoBelow = below;
  isoLower = below > 0 ? texelFetch(isoValues, 2 * below - 2).x - IsoRounding : -1e38;
  isoUpper =
    below < numberOfIsoValues ? texelFetch(isoValues, 2 * below).x - IsoRounding : 1e38;
}

void beginSurfaces()
{
  setIsoBelow(0);
  isIsoNew = true;
  isoScalar = 0.0;
  isoDepth = -1e30;
}

// Test for isosurfaces at the front of a segment.
void meetSurfaces(Scalars front)
{
  float scalar = componentOf(front, isoComponent);
  bool touches =
    partDepths.x - isoDepth <= IsoTouching && abs(scalar - isoScalar) <= isoSame;
  if (isIsoNew && !touches)
  {
    setIsoBelow(0);
    while (isoUpper <= scalar)
    {
      setIsoBelow(isoBelow + 1);
    }
  }
  isIsoNew = false;
}

// Return the fraction of the segment at the next isosurface; more than 1 if there is none.
float findSurface(Scalars front, Scalars back, float from)
{
  float begin = componentOf(front, isoComponent);
  float end = componentOf(back, isoComponent);
  isoScalar = end;
  isoDepth = partDepths.y;
  bool isUp = end >= isoUpper;
#if RELEVO_CELL_SCALARS
  return 2.0; // no isosurface
#endif
  if (!isUp && end >= isoLower)
  {
    return 2.0;
  }
  float value = (isUp ? isoUpper : isoLower) + IsoRounding;
  return end == begin ? from : clamp((value - begin) / (end - begin), from, 1.0);
}

void passSurface(Scalars front, Scalars back, float share)
{
  bool isUp = componentOf(back, isoComponent) >= isoUpper;
  int number = isUp ? isoBelow : isoBelow - 1;
  vec4 color = texelFetch(isoValues, 2 * number + 1);
#if RELEVO_CURVES == 0
  color.rgb = getColors(mix(front, back, share)).rgb;
#elif RELEVO_TABLES
  Piece kept = pieces[isoCurve];
  float value = texelFetch(isoValues, 2 * number).x;
  findPiece(isoCurve, value);
  color = evaluatePiece(isoCurve, value);
  color.a = min(color.a * unitDistances[isoCurve], 1.0);
  pieces[isoCurve] = kept;
#endif
#if RELEVO_LIT
  color.rgb = lightenSurface(isoCurve, color.rgb, share);
#endif
  collected = frontOverBack(collected, vec4(color.rgb * color.a, color.a));
  setIsoBelow(isUp ? isoBelow + 1 : isoBelow - 1);
}
