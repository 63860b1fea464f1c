// Scalars to map to colours, and their coordinates in VTK's texture of the table. For vertex and
// fragment shaders.

uniform samplerBuffer relevoScalars;  // components minus the table's bias, per point
uniform int relevoScalarTexels; // per point; 0 for one number, more for the length of a vector
uniform int relevoScalarsAreIntegers; // 1 for whole numbers, which stay whole between the points
uniform vec3 relevoScalarCoordinates; // for textures: minimum, 1 / width, 1 for a log scale

vec4 relevoScalarsAsTyped(vec4 scalars)
{
  return relevoScalarsAreIntegers == 1 ? sign(scalars) * floor(abs(scalars) + 0.5) : scalars;
}

vec2 relevoTextureCoordinate(float value)
{
  if (value != value)
  {
    return vec2(0.5, 1.0);
  }
  if (relevoScalarCoordinates.z == 1.0)
  {
    value = value > 0.0 ? log2(value) * 0.30102999566 : relevoScalarCoordinates.x;
  }
  return vec2(
    clamp((value - relevoScalarCoordinates.x) * relevoScalarCoordinates.y, -1000.0, 1000.0), 0.49);
}
