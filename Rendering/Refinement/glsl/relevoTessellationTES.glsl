// A vertex that OpenGL's tessellator has made of a face. After relevoEdgeSegments.glsl.

layout(triangles, equal_spacing, ccw) in;

patch in int relevoPatchFace;
patch in ivec3 relevoPatchSegments;
patch in int relevoPatchTurned;

vec3 relevoPlaceVertex()
{
  relevoFaceIndex = relevoPatchFace;
  // Winding is that of the coordinates, so those of a turned face are swapped.
  vec3 w = relevoPatchTurned == 1 ? gl_TessCoord.yxz : gl_TessCoord;
  // How exact coordinates on the border are is up to the driver, but two faces must have the same.
  // No other point comes as near to an edge.
  const float margin = 0.002;
  w = mix(w, vec3(0.0), vec3(lessThan(w, vec3(margin))));
  return relevoSnapToSegments(w, relevoPatchSegments);
}

int relevoColorIndex()
{
  return relevoPatchFace;
}

int relevoLineEdges()
{
  return 0;
}
