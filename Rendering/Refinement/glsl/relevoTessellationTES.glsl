// A vertex that OpenGL's tessellator has made of a face.

layout(triangles, equal_spacing, ccw) in;

patch in int relevoPatchFace;
patch in ivec3 relevoPatchSegments;
patch in int relevoPatchTurned;

vec3 relevoPlaceVertex()
{
  relevoFaceIndex = relevoPatchFace;
  // How exact coordinates on edges are is up to the driver; those of two faces must be the same.
  vec3 w = relevoPatchTurned == 1 ? gl_TessCoord.yxz : gl_TessCoord;
  return snapToBorder(w, relevoPatchSegments);
}

int relevoColorIndex()
{
  return relevoPatchFace;
}

int relevoLineEdges()
{
  return 0;
}
