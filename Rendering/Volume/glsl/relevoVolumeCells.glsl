// Unsplit cells: hexahedra with bilinear faces, and quadratic tetrahedra. Wedges and pyramids are
// hexahedra with coincident corners.

uniform usamplerBuffer curvedCells;
uniform int numberOfTetrahedra;

const int FirstBehind = 10; // word of a cell where the neighbours begin
const uint Quadratic = 0xfffffff0u; // marks a quadratic tetrahedron, in the last word

bool isCurvedCell(uint cell)
{
  return !RELEVO_TETRAHEDRA || cell >= uint(numberOfTetrahedra);
}

uint wordOfCell(uint cell, int word)
{
  return texelFetch(curvedCells, 4 * (int(cell) - numberOfTetrahedra) + word / 4)[word % 4];
}

bool isQuadraticCell(uint cell)
{
  return RELEVO_QUADRATIC != 0 && wordOfCell(cell, 15) == Quadratic;
}

int numberOfFaces(bool isQuadratic)
{
  return isQuadratic ? 4 : 6;
}

// Return the corner of a face, seen counterclockwise from outside: four for a hexahedron, or three
// for a quadratic tetrahedron, each followed by the midpoint of the next edge.
int cornerOfFace(bool isQuadratic, int face, int i)
{
  const int hexahedron[24] = int[24](
    0, 4, 7, 3, 1, 2, 6, 5, 0, 1, 5, 4, 3, 7, 6, 2, 0, 3, 2, 1, 4, 5, 6, 7);
  const int tetrahedron[24] = int[24](
    0, 4, 1, 8, 3, 7, 1, 5, 2, 9, 3, 8, 2, 6, 0, 7, 3, 9, 0, 6, 2, 5, 1, 4);
  return isQuadratic ? tetrahedron[6 * face + i] : hexahedron[4 * face + i];
}

// Return the points of a hexahedron's face, in the order of cornerOfFace(). Selections are faster
// than arrays with indices that vary.
uvec4 pointsOfHexFace(uint cell, int face)
{
  int at = 4 * (int(cell) - numberOfTetrahedra);
  uvec4 low = texelFetch(curvedCells, at);
  uvec4 high = texelFetch(curvedCells, at + 1);
  return face == 0 ? uvec4(low.x, high.x, high.w, low.w)
    : face == 1    ? uvec4(low.y, low.z, high.z, high.y)
    : face == 2    ? uvec4(low.x, low.y, high.y, high.x)
    : face == 3    ? uvec4(low.w, high.w, high.z, low.z)
    : face == 4    ? uvec4(low.x, low.w, low.z, low.y)
                   : high;
}

int sizeOfBorder(bool isQuadratic)
{
  return isQuadratic ? 6 : 4;
}
