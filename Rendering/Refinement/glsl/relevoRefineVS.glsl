// Runs first in main() and computes the attributes that VTK's code uses as the vertex.

void relevoRefine()
{
  vec3 w = relevoPlaceVertex();
  relevoVertexWeights = w;
  relevoFace = texelFetch(relevoFaces, relevoFaceIndex);

  precise vec3 position = surfacePosition(w);
#ifdef RELEVO_NORMALS
  vec3 normal = surfaceNormal(w);
#ifdef RELEVO_DISPLACEMENT
  DisplacedPoint point = displace(w, normal);
  position += point.Vector * relevoPositionScale;
  normal = point.Normal;
#endif
  relevoNormal = unitVector(normal); // fragments interpolate unit normals, like those of the filter
  relevoSetNormal(relevoNormal);
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
#ifdef RELEVO_COLORS_OF_FACES
  relevoColorVSOutput = relevoFaceColor();
#endif
#ifdef RELEVO_COLORS_OF_TAGS
  relevoTagsVSOutput = relevoFaceTags();
  relevoTagWeightsVSOutput = w;
#endif
#ifdef RELEVO_LINES
  // Diagonals of coarse polygons are hidden.
  relevoHidden = relevoHidden || (relevoFace.w & relevoLineEdges()) != 0;
#endif
  relevoExtend();
}
