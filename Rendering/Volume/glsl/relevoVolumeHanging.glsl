// Cells next to smaller ones: points hang on their edges, and several cells are behind a face. All
// cells around an edge use its pieces, so that they get the same result next to it.

const uint SeveralCells = 5u; // instead of the index of a face

// Return a word of a list, whose address is a number of blocks of four words.
uint wordOfList(uint address, int word)
{
  return texelFetch(curvedCells, int(address) + word / 4)[word % 4];
}

// Return passesOf() for an edge of a hexahedron, whose list of edges has this address; 0 for none.
int passesOfEdge(uint edges, int edge, Corner a, Corner b)
{
  uint points = edges == 0u ? 0u : wordOfList(edges, edge);
  int count = points == 0u ? 0 : int(wordOfList(points, 0));
  int passes = 0;
  Corner from = a;
  for (int i = 1; i <= count; ++i)
  {
    Corner to = getCorner(wordOfList(points, i));
    passes += passesOf(from, to);
    from = to;
  }
  return passes + passesOf(from, b);
}

// Return windingOf() for a face of a hexahedron.
int windingOfFace(uint cell, int face, Corner border[6])
{
  // The edges between the corners of faces, in the order of windHexahedron(), and whether their
  // direction is that of the face.
  const int edges[24] =
    int[24](8, 7, 11, 3, 1, 10, 5, 9, 0, 9, 4, 8, 11, 6, 10, 2, 3, 2, 1, 0, 4, 5, 6, 7);
  const int ways[24] =
    int[24](1, 0, 0, 1, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1, 1);
  uint list = wordOfCell(cell, 8);
  int winding = 0;
  for (int i = 0; i < 4; ++i)
  {
    int edge = edges[4 * face + i];
    int next = (i + 1) % 4;
    winding += ways[4 * face + i] == 1 ? passesOfEdge(list, edge, border[i], border[next])
                                       : -passesOfEdge(list, edge, border[next], border[i]);
  }
  return winding;
}
