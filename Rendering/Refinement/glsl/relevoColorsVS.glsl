// Scalars interpolated over the refined surface, then mapped to colours.

uniform samplerBuffer relevoScalars;     // components less relevoScalarBias, per point
uniform samplerBuffer relevoScalarTable; // colours, then those below, above and for NaN
uniform float relevoScalarMinimum;       // less the bias; of the logarithms for a log scale
uniform float relevoScalarFactor;        // 1 / (maximum - minimum)
uniform int relevoScalarColors;          // number of colours of the table
uniform int relevoScalarMagnitude;       // 1 for the length of a vector
uniform int relevoScalarLog;             // 1 for a log scale

vec4 relevoScalarColor(vec3 w)
{
  vec4 scalars = weightedSum(texelFetch(relevoScalars, relevoFace.x),
    texelFetch(relevoScalars, relevoFace.y), texelFetch(relevoScalars, relevoFace.z), w);
  float value = relevoScalarMagnitude == 1 ? length(scalars) : scalars.x;
  if (relevoScalarLog == 1)
  {
    value = value > 0.0 ? log2(value) * 0.30102999566 : relevoScalarMinimum - 1.0;
  }
  float t = (value - relevoScalarMinimum) * relevoScalarFactor;
  int index = clamp(int(floor(t * float(relevoScalarColors))), 0, relevoScalarColors - 1);
  index = t < 0.0 ? relevoScalarColors : (t > 1.0 ? relevoScalarColors + 1 : index);
  index = value != value ? relevoScalarColors + 2 : index;
  return texelFetch(relevoScalarTable, index);
}
