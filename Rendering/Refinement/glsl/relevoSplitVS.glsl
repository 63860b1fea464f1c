// A vertex of the stream on its way to relevoSplitGS.glsl.

in vec3 relevoWeights;
in uint relevoFace; // face << 3 | levels left of the edge to the next vertex

out vec3 relevoWeightsVSOutput;
flat out uint relevoFaceVSOutput;

void main()
{
  relevoWeightsVSOutput = relevoWeights;
  relevoFaceVSOutput = relevoFace;
}
