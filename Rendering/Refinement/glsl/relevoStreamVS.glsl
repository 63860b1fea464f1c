// A vertex of the refined stream that relevoSplitGS.glsl has written.

in vec3 relevoStreamWeights;
in uint relevoStreamFace; // face << 3 | levels left, by now none

vec3 relevoPlaceVertex()
{
  relevoFaceIndex = int(relevoStreamFace >> 3);
  return relevoStreamWeights;
}

int relevoColorIndex()
{
  return relevoFaceIndex;
}
