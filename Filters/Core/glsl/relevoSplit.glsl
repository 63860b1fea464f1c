// How a triangle is split until none of its edges has levels left: one step. GLSL and C++.
//
// Every edge that has levels left is cut at its middle; its halves have one less. What joins two
// middles gets the mean of the two edges' levels, rounded down, less one, as if the ends of edges
// had depth-tags. What joins a middle and the corner opposite gets half of the edge's levels,
// rounded down. The edges that a triangle shares with others are cut the same in both; the largest
// number of levels falls by one with each step.
//
// Corners of parts: 0, 1, 2 are the triangle's, 3, 4, 5 the middles of its edges (0,1), (1,2),
// (2,0). All edges are in this order, and all parts wind as the triangle does.

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

// Parts of a triangle whose first edge is cut, if one is, or whose last edge is not, if two are.
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
    // Of the four corners left, the middle of the edge with more levels is joined to the other end
    // of the edge that is not cut.
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

// The part of this number, below splitCount().
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
