// The position of a vertex of a face. Follows relevoTerrainHeightsVS.glsl.

// Return the column and row, relative to relevoOrigin.
vec2 relevoSamples(ivec2 ab)
{
  return vec2((relevoFaceVertex(ab) << relevoUnitShift) - relevoOrigin) *
    relevoFractions[-RELEVO_FINEST_LEVEL];
}

#ifndef RELEVO_GLOBE
// The same integers give the same position in all faces that share the vertex.
vec3 relevoMapPoint(vec2 samples, float height)
{
  precise vec3 position =
    vec3(samples.x * relevoPlacement.xy + samples.y * relevoPlacement.zw,
      (height - relevoOriginHeight) * relevoHeightScale);
  return position;
}
#endif
