#ifdef RELIEF_NORMALS
uniform mat3 normalMatrix;

vec3 reliefNormal()
{
  return normalize(normalMatrix * warpedMix(warpedNormals).xyz);
}
#else
vec3 warpedNormal = vec3(0.0);

vec3 reliefNormal()
{
  return warpedNormal;
}
#endif

vec3 warpedPlane = vec3(0.0); // normal of the surface, in coordinates of the tiles

float reliefSquareness()
{
  return abs(warpedPlane.z);
}

bool reliefFind()
{
  bool found = warpedFind();
  warpedPlane = normalize(cross(dFdx(reliefPoint), dFdy(reliefPoint)));
#ifndef RELIEF_NORMALS
  vec3 place = reliefVertex().xyz;
  warpedNormal = normalize(cross(dFdx(place), dFdy(place)));
#endif
  reliefCutPlanes();
  return found && reliefIsInside && reliefSides.x;
}
