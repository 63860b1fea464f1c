// A vertex of the refined stream, which relevoSplitGS.glsl has written.

in vec3 relevoStreamWeights;
in uint relevoStreamFace; // face << 3 | levels left, which are 0 here

vec3 relevoPlaceVertex()
{
  relevoFaceIndex = int(relevoStreamFace >> 3);
  return relevoStreamWeights;
}

int relevoColorIndex()
{
  return relevoFaceIndex;
}
