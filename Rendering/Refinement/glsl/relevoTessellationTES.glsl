// A vertex that OpenGL's tessellator has generated on a face. Follows relevoEdgeSegments.glsl.

layout(triangles, equal_spacing, ccw) in;

patch in int relevoPatchFace;
patch in ivec3 relevoPatchSegments;
patch in int relevoPatchTurned;

vec3 relevoPlaceVertex()
{
  relevoFaceIndex = relevoPatchFace;
  // The winding is that of the coordinates, so those of a turned face are swapped.
  vec3 w = relevoPatchTurned == 1 ? gl_TessCoord.yxz : gl_TessCoord;
  // OpenGL does not define how exact coordinates on the border are, but two faces must share them.
  // No interior point is this close to an edge.
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
