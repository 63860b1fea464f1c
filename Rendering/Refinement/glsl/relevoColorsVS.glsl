// Scalars interpolated over the refined surface, then mapped to colours.

uniform samplerBuffer relevoScalars; // components less the table's bias, per point
uniform int relevoScalarMagnitude;   // 1 for the length of a vector

vec4 relevoScalarColor(vec3 w)
{
  vec4 scalars = weightedSum(texelFetch(relevoScalars, relevoFace.x),
    texelFetch(relevoScalars, relevoFace.y), texelFetch(relevoScalars, relevoFace.z), w);
  return relevoTableColor(relevoScalarMagnitude == 1 ? length(scalars) : scalars.x);
}
