// A point of a pattern's triangle, discarded where the surface is open.
flat in vec4 reliefPlaceVSOutput;
flat in ivec4 reliefTileVSOutput;
in vec3 reliefVertexVSOutput;

bool reliefIsInside = true;

void reliefCut(vec4 plane)
{
  reliefIsInside = reliefIsInside && dot(plane, vec4(reliefPoint, 1.0)) >= 0.0;
}
