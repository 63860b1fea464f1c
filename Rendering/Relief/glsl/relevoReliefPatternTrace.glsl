bool reliefFind()
{
  reliefBox = reliefPlaceVSOutput;
  reliefTile = reliefTileVSOutput;
  reliefPlace = clamp(reliefVertexVSOutput.xy, 0.0, float(RELIEF_SIZE));
  reliefPoint = vec3(reliefBox.xy + reliefPlace, reliefVertexVSOutput.z);
  ivec2 quad = min(ivec2(reliefPlace), RELIEF_SIZE - 1);
  vec3 normal = vec3(-reliefSlopes(reliefCorners(quad), reliefPlace - vec2(quad)), 1.0);
  reliefIsFront = dot(normal, reliefEye.xyz - reliefPoint * reliefEye.w) > 0.0;
  reliefCutPlanes();
  return reliefIsInside && (reliefIsFront ? reliefSides.x : reliefSides.y) && reliefIsQuad(quad);
}
