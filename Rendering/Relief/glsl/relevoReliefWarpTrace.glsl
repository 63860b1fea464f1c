#ifdef RELIEF_NORMALS
uniform mat3 normalMatrix;

vec3 reliefNormal()
{
  return normalize(normalMatrix * warpedMix(warpedNormals).xyz);
}
#else
vec3 warpedNormal;

vec3 reliefNormal()
{
  return warpedNormal;
}
#endif

bool reliefFind()
{
  bool found = warpedFind();
#ifndef RELIEF_NORMALS
  vec3 place = reliefVertex().xyz;
  warpedNormal = normalize(cross(dFdx(place), dFdy(place)));
#endif
  reliefCutPlanes();
  return found && reliefIsInside && reliefSides.x;
}
