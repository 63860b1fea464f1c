// Return whether the side of a refined triangle between vertices a and b is on a diagonal of a
// coarse polygon, which is not a visible edge.
bool relevoIsHiddenSide(int a, int b)
{
  bvec3 onEdge = equal(relevoWeightsVSOutput[a] + relevoWeightsVSOutput[b], vec3(0.0));
  int hidden = relevoHiddenEdgesVSOutput[0];
  return (onEdge.z && (hidden & 1) != 0) || (onEdge.x && (hidden & 2) != 0) ||
    (onEdge.y && (hidden & 4) != 0);
}
