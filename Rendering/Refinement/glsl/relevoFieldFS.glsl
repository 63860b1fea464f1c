// The colour of a fragment from point scalars that the surface evaluates. Follows the surface's
// fieldPlace() and, if there are values, relevoScalars.glsl.

uniform int relevoFieldSize; // number of values
#ifdef RELEVO_FIELD_COLORS
uniform samplerBuffer relevoFieldColors;
#endif

vec4 relevoFieldAt(int index, int texel)
{
#if defined(RELEVO_FIELD_COLORS)
  return texelFetch(relevoFieldColors, index);
#else
  return texelFetch(relevoScalars, index * max(relevoScalarTexels, 1) + texel);
#endif
}

// Values of weight 0 are ignored, even if they are NaN.
vec4 relevoFieldSum(FieldPlace place, int texel)
{
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    int index = clamp(place.Indices[corner], 0, relevoFieldSize - 1);
    sum += place.Weights[corner] == 0.0 ? vec4(0.0)
                                        : place.Weights[corner] * relevoFieldAt(index, texel);
  }
  return sum;
}

vec4 relevoFieldColor()
{
  // Multisampling may evaluate weights outside a face.
  vec3 weights = max(relevoFieldWeightsVSOutput, vec3(0.0));
  FieldPlace place =
    fieldPlace(relevoFieldVSOutput, weights / (weights.x + weights.y + weights.z));
#if defined(RELEVO_FIELD_COLORS)
  return clamp(relevoFieldSum(place, 0), 0.0, 1.0);
#else
  float number = 0.0;
  if (relevoScalarTexels == 0)
  {
    number = relevoScalarsAsTyped(relevoFieldSum(place, 0)).x;
  }
  else
  {
    for (int texel = 0; texel < relevoScalarTexels; ++texel)
    {
      vec4 values = relevoScalarsAsTyped(relevoFieldSum(place, texel));
      number += dot(values, values);
    }
    number = sqrt(number);
  }
#ifdef RELEVO_FIELD_TEXTURE
  return textureLod(colortexture, relevoTextureCoordinate(number), 0.0);
#else
  return relevoTableColor(number);
#endif
#endif
}
