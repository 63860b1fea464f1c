// Positions in the geocentric frame, relative to an origin near the eye. Except for rounding errors,
// they equal those of GlobeFaces.cxx. Follows relevoTerrainFaceVS.glsl.

uniform samplerBuffer relevoGlobeVertices; // position at relevoOriginHeight, up, derivatives
uniform float relevoOriginHeight;
uniform float relevoHeightScale; // metres per unit of height, with the exaggeration

vec3 relevoGlobePosition;        // of the vertex, after relevoVertex()
vec3 relevoMidpoint = vec3(0.0); // of the edge on which the bisection adds the vertex

vec4 relevoGlobeTexel(ivec2 ab, int texel)
{
  int index = ab.y * (2 * RELEVO_SEGMENTS + 3 - ab.y) / 2 + ab.x;
  return texelFetch(relevoGlobeVertices, 3 * (relevoFace * RELEVO_FACE_VERTICES + index) + texel);
}

vec3 relevoGlobePoint(ivec2 ab, float height)
{
  precise vec3 point = relevoGlobeTexel(ab, 0).xyz +
    ((height - relevoOriginHeight) * relevoHeightScale) * relevoGlobeTexel(ab, 1).xyz;
  return point;
}
