// Isosurfaces. Where the ray is, so many values are not more than the scalar; where that changes
// inside a cell, or between cells that touch, it meets a surface.

uniform samplerBuffer isoValues; // in ascending order; two texels each: the value, and its colour
uniform int numberOfIsoValues;
uniform int isoComponent;
uniform int isoCurve;
uniform float isoSame; // cells that touch may differ so much

// Scalars are from 0 to 1. Those of cells whose corners have one value differ no more from it.
const float IsoRounding = 5e-7;
// Of depths, in radii of the mesh: cells no farther apart touch.
const float IsoTouching = 1e-5;

int isoBelow; // how many values are not more than the scalar
float isoLower; // the last of them
float isoUpper; // the next one
bool isIsoNew; // whether the walk has just begun
float isoScalar; // where the ray was last
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

// At the front of a part.
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

// The share of the part where the next surface is, more than 1 if there is none.
float findSurface(Scalars front, Scalars back, float from)
{
  float begin = componentOf(front, isoComponent);
  float end = componentOf(back, isoComponent);
  isoScalar = end;
  isoDepth = partDepths.y;
  bool isUp = end >= isoUpper;
#if RELEVO_CELL_SCALARS
  return 2.0; // there are none
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
