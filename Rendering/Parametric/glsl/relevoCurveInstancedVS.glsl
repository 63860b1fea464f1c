// A vertex of one of several curves that an instance draws.

// first curve of the group in relevoInstances, number of curves, copies of the pattern per
// instance, segments per curve
uniform ivec4 relevoGroup;
uniform usamplerBuffer relevoInstances;

// Return the quotient of integers below 65536. Adding 0.5 prevents rounding to the next integer.
int relevoQuotient(int dividend, int divisor)
{
  return int((float(dividend) + 0.5) / float(divisor));
}

void relevoPlaceVertex()
{
  int vertices = (relevoGroup.w + RELEVO_MORE_RINGS + 1) * RELEVO_SIDES;
  int copy = relevoQuotient(gl_VertexID, vertices);
  int vertex = gl_VertexID - copy * vertices;
  relevoRing = relevoQuotient(vertex, RELEVO_SIDES);
  relevoSide = vertex - relevoRing * RELEVO_SIDES;
  // An instance may have more copies than curves.
  int member = relevoGroup.x + gl_InstanceID * relevoGroup.z + copy;
  int end = relevoGroup.x + relevoGroup.y;
  relevoHidden = member >= end;
  relevoTakeCurve(int(texelFetch(relevoInstances, min(member, end - 1)).r));
}
