// Between points of which one has no data there are none.

uniform samplerBuffer relevoNoData; // per point 1 for no data
uniform float relevoNotANumber;

// The weights of corners without data. The mesh's own points keep what they have.
vec3 relevoNoDataWeights(vec3 w)
{
  vec3 marks = vec3(texelFetch(relevoNoData, relevoFace.x).r,
    texelFetch(relevoNoData, relevoFace.y).r, texelFetch(relevoNoData, relevoFace.z).r);
  return max(max(w.x, w.y), w.z) == 1.0 ? vec3(0.0) : marks * w;
}
