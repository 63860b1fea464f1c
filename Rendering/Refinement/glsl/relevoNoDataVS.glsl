// If one of several points has no data, positions between them have none.

uniform samplerBuffer relevoNoData; // 1 for points without data
uniform float relevoNotANumber;

// Return the weights of corners without data. Points of the mesh itself keep their values.
vec3 relevoNoDataWeights(vec3 w)
{
  vec3 marks = vec3(texelFetch(relevoNoData, relevoFace.x).r,
    texelFetch(relevoNoData, relevoFace.y).r, texelFetch(relevoNoData, relevoFace.z).r);
  return max(max(w.x, w.y), w.z) == 1.0 ? vec3(0.0) : marks * w;
}
