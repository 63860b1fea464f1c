// Definitions shared by the functions of a procedural surface.

uniform float relevoAmplitude;
uniform float relevoFrequency;

// The derivatives of a height: with respect to the position in the mesh's coordinates, and to each
// weight.
struct HeightGradient
{
  vec3 ByPosition;
  vec3 ByWeights;
};
