// What the functions of a procedural surface have in common.

uniform float relevoAmplitude;
uniform float relevoFrequency;

// The derivatives of a height: by the position in the mesh's coordinates, and by each weight alone.
struct HeightGradient
{
  vec3 ByPosition;
  vec3 ByWeights;
};
