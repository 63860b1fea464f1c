// One refinement pass: splits a triangle into up to four, which are fed back. Follows
// relevoSplit.glsl.

layout(triangles) in;
layout(triangle_strip, max_vertices = 12) out;

in vec3 relevoWeightsVSOutput[];
flat in uint relevoFaceVSOutput[];

out vec3 relevoWeightsGSOutput;
flat out uint relevoFaceGSOutput;

// The weights are exact, because they are multiples of powers of two.
vec3 relevoCornerWeights(int corner)
{
  int first = corner % 3;
  vec3 w = relevoWeightsVSOutput[first];
  return corner < 3 ? w : 0.5 * (w + relevoWeightsVSOutput[(first + 1) % 3]);
}

void main()
{
  ivec3 left = ivec3(int(relevoFaceVSOutput[0] & 7u), int(relevoFaceVSOutput[1] & 7u),
    int(relevoFaceVSOutput[2] & 7u));
  uint face = relevoFaceVSOutput[0] & ~7u;
  int count = splitCount(left);
  for (int i = 0; i < count; ++i)
  {
    SplitPart part = splitPart(left, i);
    for (int k = 0; k < 3; ++k)
    {
      relevoWeightsGSOutput = relevoCornerWeights(part.Corners[k]);
      relevoFaceGSOutput = face | uint(part.Left[k]);
      EmitVertex();
    }
    EndPrimitive();
  }
}
