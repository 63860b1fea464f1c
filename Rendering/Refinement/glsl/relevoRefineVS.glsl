// Run first in main(): turns the pattern vertex into what VTK's code takes for the vertex.

void relevoRefine()
{
  int instance = int(texelFetch(relevoInstances, relevoInstanceOffset + gl_InstanceID).r);
  int code = instance & 7;
  relevoFaceIndex = instance >> 3;
  relevoFace = texelFetch(relevoFaces, relevoFaceIndex);
  vec3 w = permuteWeights(relevoPatternVertex.xyz, code);

  precise vec3 position = surfacePosition(w);
#ifdef RELEVO_NORMALS
  vec3 normal = surfaceNormal(w);
#ifdef RELEVO_DISPLACEMENT
  DisplacedPoint point = displace(w, normal);
  position += point.Vector * relevoPositionScale;
  normal = point.Normal;
#endif
  relevoSetNormal(normal);
#endif
  vertexMC = vec4(position, 1.0);
  relevoSetAttributes(w);

  relevoPrimitiveIDVSOutput = relevoFace.w >> 3;
  relevoPointId = w.x >= w.y && w.x >= w.z ? relevoFace.x : (w.y >= w.z ? relevoFace.y : relevoFace.z);
#ifdef RELEVO_EDGES
  relevoWeightsVSOutput = w;
  relevoHiddenEdgesVSOutput = relevoFace.w & 7;
#endif
#ifdef RELEVO_HOLES
  relevoHeightCoordinateVSOutput = heightCoordinate(heightPoints(w), w);
  relevoValidVSOutput = heightValid(relevoHeightCoordinateVSOutput) ? 1.0 : 0.0;
#endif
}

#ifdef RELEVO_LINES
// Whether a line lies on a diagonal of a coarse polygon.
bool relevoIsHiddenLine()
{
  int edge = int(relevoPatternVertex.w) - 2;
  if (edge < 0)
  {
    return false;
  }
  // The pattern's edge lacks this corner; which sorted corner is that?
  vec3 lacking = edge == 0 ? vec3(0.0, 0.0, 1.0) : (edge == 1 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0));
  int code = int(texelFetch(relevoInstances, relevoInstanceOffset + gl_InstanceID).r & 7u);
  vec3 sortedLacking = permuteWeights(lacking, code);
  int hidden = sortedLacking.z > 0.0 ? 1 : (sortedLacking.x > 0.0 ? 2 : 4);
  return (relevoFace.w & hidden) != 0;
}
#endif
