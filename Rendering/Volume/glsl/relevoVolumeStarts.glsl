// The faces where rays may enter: those of the mesh's border, those of the active cells, or both.

#if RELEVO_ACTIVE || RELEVO_VISIBLE || RELEVO_DISCONTINUOUS
uniform usamplerBuffer tetrahedronCorners; // in ascending order
#endif

#if RELEVO_ACTIVE || RELEVO_VISIBLE
uniform usamplerBuffer startFaces; // 8 * cell + the index of the face

// The face of a tetrahedron opposite to a corner, with the corners in order as seen by an entering
// ray.
uvec4 wordsOfTriangle(uint cell, uint number)
{
  uvec4 all = texelFetch(tetrahedronCorners, int(cell));
  uvec4 face = number == 0u ? all.yzwx : number == 1u ? all.xzwy : number == 2u ? all.xywz : all;
  vec3 origin = texelFetch(meshPoints, int(face.x)).xyz;
  vec3 b = texelFetch(meshPoints, int(face.y)).xyz - origin;
  vec3 c = texelFetch(meshPoints, int(face.z)).xyz - origin;
  vec3 inside = texelFetch(meshPoints, int(face.w)).xyz - origin;
  return uvec4(dot(cross(b, c), inside) < 0.0 ? face.xzy : face.xyz, cell);
}

uvec4 wordsOfStart(int face)
{
  uint start = texelFetch(startFaces, face).r;
  uint cell = start / 8u;
#if RELEVO_CURVED
  if (isCurvedCell(cell))
  {
    return uvec4(start % 8u, 0u, 0u, cell);
  }
#endif
  return wordsOfTriangle(cell, start % 8u);
}
#endif

#if RELEVO_ACTIVE
uvec4 wordsOfFace(int face)
{
  return wordsOfStart(face);
}
#else
uniform usamplerBuffer borderFaces;

#if RELEVO_VISIBLE
uniform int numberOfBorderFaces; // the faces of active cells have the following numbers
#endif

uvec4 wordsOfFace(int face)
{
#if RELEVO_VISIBLE
  if (face >= numberOfBorderFaces)
  {
    return wordsOfStart(face - numberOfBorderFaces);
  }
#endif
  return texelFetch(borderFaces, face);
}
#endif
