// Passes a vertex of the stream to relevoSplitGS.glsl.

in vec3 relevoWeights;
in uint relevoFace; // face << 3 | levels left on the edge to the next vertex

out vec3 relevoWeightsVSOutput;
flat out uint relevoFaceVSOutput;

void main()
{
  relevoWeightsVSOutput = relevoWeights;
  relevoFaceVSOutput = relevoFace;
}
