// One step of splitting a triangle until no edge has levels left. GLSL and C++.
//
// Every edge with levels left is split at its midpoint, and the halves have one level less. A new
// edge between two midpoints gets the mean of the two edges' levels, rounded down, minus one, as if
// the ends of edges had depth-tags. A new edge between a midpoint and the opposite corner gets half
// the levels of the split edge, rounded down. Shared edges are split in the same way in both
// triangles. The largest number of levels decreases by one in each step.
//
// Corners 0, 1, 2 of parts are those of the triangle. 3, 4, 5 are the midpoints of its edges (0,1),
// (1,2), (2,0). All edges are in this order, and all parts have the winding of the triangle.

struct SplitPart
{
  ivec3 Corners;
  ivec3 Left; // levels
};

RELEVO_FUNCTION int splitCount(ivec3 left)
{
  return 1 + (left.x > 0 ? 1 : 0) + (left.y > 0 ? 1 : 0) + (left.z > 0 ? 1 : 0);
}

RELEVO_FUNCTION SplitPart makeSplitPart(int a, int b, int c, int ab, int bc, int ca)
{
  SplitPart part;
  part.Corners = ivec3(a, b, c);
  part.Left = ivec3(ab, bc, ca);
  return part;
}

RELEVO_FUNCTION int splitJoin(int a, int b)
{
  return (a + b) / 2 - 1;
}

// Parts of a triangle whose first edge is split, if one is, or whose last edge is not, if two are.
RELEVO_FUNCTION SplitPart splitTurned(ivec3 left, int part)
{
  int a = left.x;
  int b = left.y;
  int c = left.z;
  if (c > 0)
  {
    return part == 0 ? makeSplitPart(0, 3, 5, a - 1, splitJoin(a, c), c - 1)
      : part == 1    ? makeSplitPart(3, 1, 4, a - 1, b - 1, splitJoin(a, b))
      : part == 2    ? makeSplitPart(5, 4, 2, splitJoin(b, c), b - 1, c - 1)
                  : makeSplitPart(3, 4, 5, splitJoin(a, b), splitJoin(b, c), splitJoin(a, c));
  }
  if (b > 0)
  {
    // The midpoint of the edge with more levels is connected to the other end of the edge that is
    // not split.
    int join = splitJoin(a, b);
    int across = max(a, b) / 2;
    return part == 0 ? makeSplitPart(3, 1, 4, a - 1, b - 1, join)
      : part == 1    ? (a >= b ? makeSplitPart(0, 3, 2, a - 1, across, c)
                               : makeSplitPart(0, 3, 4, a - 1, join, across))
                     : (a >= b ? makeSplitPart(3, 4, 2, join, b - 1, across)
                               : makeSplitPart(0, 4, 2, across, b - 1, c));
  }
  if (a > 0)
  {
    return part == 0 ? makeSplitPart(0, 3, 2, a - 1, a / 2, c)
                     : makeSplitPart(3, 1, 2, a - 1, b, a / 2);
  }
  return makeSplitPart(0, 1, 2, a, b, c);
}

// The part with this number, which is less than splitCount().
RELEVO_FUNCTION SplitPart splitPart(ivec3 left, int part)
{
  int turn = 0;
  int count = splitCount(left);
  if (count == 2)
  {
    turn = left.x > 0 ? 0 : (left.y > 0 ? 1 : 2);
  }
  else if (count == 3)
  {
    turn = left.z == 0 ? 0 : (left.x == 0 ? 1 : 2);
  }
  ivec3 turned = turn == 0 ? left
    : turn == 1            ? ivec3(left.y, left.z, left.x)
                           : ivec3(left.z, left.x, left.y);
  SplitPart result = splitTurned(turned, part);
  for (int i = 0; i < 3; ++i)
  {
    int corner = result.Corners[i];
    result.Corners[i] = corner < 3 ? (corner + turn) % 3 : 3 + (corner + turn) % 3;
  }
  return result;
}
