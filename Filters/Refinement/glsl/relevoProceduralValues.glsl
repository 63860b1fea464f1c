// What the functions of a procedural surface have in common.

uniform float relevoAmplitude;
uniform float relevoFrequency;

// Of a height: by the position in the mesh's coordinates, and by each weight by itself.
struct HeightGradient
{
  vec3 ByPosition;
  vec3 ByWeights;
};
