// Traces a pixel's ray through a tile.
bool reliefFind()
{
  reliefBox = reliefPlaceVSOutput;
  reliefTile = reliefTileVSOutput;
  reliefFindRay();
  reliefCutBox(vec3(reliefBox.xyz) - reliefTolerance,
    vec3(reliefBox.xy + float(RELIEF_SIZE), reliefBox.w) + reliefTolerance);
  reliefCutPlanes();
  reliefToPass = reliefTile.w;
  reliefSeen = reliefSides;
  reliefHit = reliefRange.x <= reliefRange.y && reliefMeetTile();
  reliefSeen = bvec2(true);
  return reliefHit;
}
