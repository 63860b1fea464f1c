// The field of a fragment's patch, evaluated with the patch's own basis. Follows relevoPatch.glsl
// and, if there are values, relevoScalars.glsl.

#ifdef RELEVO_RATIONAL
uniform samplerBuffer relevoTablePoints; // control points: positions, weights
#endif
#ifdef RELEVO_FIELD_COLORS
uniform samplerBuffer relevoFieldColors; // colours of the control points
#endif

int relevoFieldTexel = 0; // index of a control point's texel; -1 for its weight

bool relevoIsRational()
{
#ifdef RELEVO_RATIONAL
  return (relevoPatchVSOutput.y & 8192) != 0;
#else
  return false;
#endif
}

float relevoWeight(int i)
{
#ifdef RELEVO_RATIONAL
  return relevoIsRational() ? texelFetch(relevoTablePoints, i).w : 1.0;
#else
  return 1.0;
#endif
}

PATCH_VECTOR patchPoint(int i)
{
  float weight = relevoWeight(i);
  if (relevoFieldTexel < 0)
  {
    return PATCH_VECTOR(weight);
  }
#if defined(RELEVO_FIELD_COLORS)
  return texelFetch(relevoFieldColors, i) * weight;
#elif defined(RELEVO_FIELD_NUMBER)
  return texelFetch(relevoScalars, i).x * weight;
#else
  return texelFetch(relevoScalars, i * relevoScalarTexels + relevoFieldTexel) * weight;
#endif
}

// Multisampling may evaluate positions outside a patch, which have no field; the coordinates are
// clamped.
vec2 relevoFieldCoordinate()
{
  vec2 uv = clamp(relevoPatchCoordinateVSOutput, vec2(0.0), vec2(1.0));
  bool isBeyond = (relevoPatchVSOutput.y & 256) != 0 && uv.x + uv.y > 1.0;
  return isBeyond ? uv / (uv.x + uv.y) : uv;
}

PatchPoint relevoFieldSum(int texel)
{
  relevoFieldTexel = texel;
  PatchShape shape = unpackShape(relevoPatchVSOutput);
#ifdef RELEVO_ISOLINES
  return patchPointAt(shape, relevoFieldCoordinate());
#else
  return PatchPoint(
    patchValueAt(shape, relevoFieldCoordinate()), PATCH_VECTOR(0.0), PATCH_VECTOR(0.0));
#endif
}

// Return a texel's values and, for isolines, their derivatives by u and by v.
PatchPoint relevoFieldAt(int texel)
{
  PatchPoint sum = relevoFieldSum(texel);
  if (relevoIsRational())
  {
    PatchPoint weight = relevoFieldSum(-1);
    sum.Point /= weight.Point;
    sum.ByU = (sum.ByU - sum.Point * weight.ByU) / weight.Point;
    sum.ByV = (sum.ByV - sum.Point * weight.ByV) / weight.Point;
  }
  return sum;
}

#ifdef RELEVO_FIELD_COLORS
vec4 relevoFieldColor()
{
  return clamp(relevoFieldAt(0).Point, 0.0, 1.0);
}
#else
// The value that is mapped to a colour, minus the table's bias.
struct FieldNumber
{
  float Typed; // whole if the array has integers
  float Exact;
  vec2 Slope; // derivative of Exact by u and by v
};

FieldNumber relevoNumber; // value of the fragment

#ifdef RELEVO_FIELD_NUMBER
FieldNumber relevoFieldNumber()
{
  PatchPoint at = relevoFieldAt(0);
  return FieldNumber(relevoScalarsAsTyped(vec4(at.Point)).x, at.Point, vec2(at.ByU, at.ByV));
}
#else
FieldNumber relevoFieldNumber()
{
  FieldNumber sum = FieldNumber(0.0, 0.0, vec2(0.0));
  for (int texel = 0; texel < relevoScalarTexels; ++texel)
  {
    PatchPoint at = relevoFieldAt(texel);
    vec4 typed = relevoScalarsAsTyped(at.Point);
    sum.Typed += dot(typed, typed);
    sum.Exact += dot(at.Point, at.Point);
    sum.Slope += vec2(dot(at.Point, at.ByU), dot(at.Point, at.ByV));
  }
  float size = sqrt(sum.Exact);
  return FieldNumber(sqrt(sum.Typed), size, size > 0.0 ? sum.Slope / size : vec2(0.0));
}
#endif

vec4 relevoNumberColor(float number)
{
#ifdef RELEVO_FIELD_TEXTURE
  return textureLod(colortexture, relevoTextureCoordinate(number), 0.0);
#else
  return relevoTableColor(number);
#endif
}
#endif
