// Run first in main(): turns the pattern vertex into what VTK's code takes for the vertex.

void relevoRefine()
{
  int instance = int(texelFetch(relevoInstances, relevoMember()).r);
  int code = instance & 7;
  relevoFaceIndex = instance >> 3;
  relevoFace = texelFetch(relevoFaces, relevoFaceIndex);
#ifdef RELEVO_MORPH
  vec3 w = morphWeights(relevoPatternVertex.xyz, texelFetch(relevoMorphTags, relevoFaceIndex).xyz);
#else
  vec3 w = permuteWeights(relevoPatternVertex.xyz, code);
#endif

  precise vec3 position = surfacePosition(w);
#ifdef RELEVO_NORMALS
  vec3 normal = surfaceNormal(w);
#ifdef RELEVO_DISPLACEMENT
  DisplacedPoint point = displace(w, normal);
  position += point.Vector * relevoPositionScale;
  normal = point.Normal;
#endif
  relevoSetNormal(unitVector(normal)); // fragments interpolate unit normals, as of the filter
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
  // Diagonals of coarse polygons are hidden. The line's edge lacks this corner of the pattern;
  // which sorted corner is that?
  float line = floor(relevoPatternVertex.w);
  if (line > 0.0)
  {
    vec3 lacking = vec3(equal(vec3(line), vec3(2.0, 3.0, 1.0)));
    vec3 sortedLacking = permuteWeights(lacking, code);
    int edge = sortedLacking.z > 0.0 ? 1 : (sortedLacking.x > 0.0 ? 2 : 4);
    relevoHidden = (relevoFace.w & edge) != 0;
  }
#endif
}
