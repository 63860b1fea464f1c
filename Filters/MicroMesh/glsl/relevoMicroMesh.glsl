// Micro-meshes; see vtkMicroMeshSurface. The including file provides relevoWeights.glsl, the corner
// functions of vtkRefinementSurface.h and its tables:
//
//   vec4 cornerValues(int i)   the displacement for a sample of 1
//   int tableEntry()           the face's first record
//   int cornerOrder()          permutation from the face's corners to the sorted ones
//   ivec4 tableRecord(int i)   four samples each, see unpackSample(); then three per face:
//     0: the first samples of the edges 0, 1 and 2 and of the points inside
//     1: the levels of the edges 0, 1 and 2 and of the face, 4 bits each; a bit for each edge whose
//        samples run from corner e + 1 to e; the lowest and highest displacement
//     2: the first grid point of the face in the values of point arrays
//
// Edge e connects corners e and (e + 1) % 3 of the face. The surface is linear on the triangles of
// the face's grid. On edges, it is computed from the data of the edge alone, in the order of the
// sorted corners.

struct MicroPoint
{
  vec3 Position;
  vec3 Normal;
};

struct MicroFace
{
  ivec4 First;
  ivec3 EdgeLevels;
  int Level;
  int Reversed;
  ivec3 Order; // corners of the face that the sorted corners are
};

RELEVO_FUNCTION MicroFace microFace()
{
  ivec4 levels = tableRecord(tableEntry() + 1);
  MicroFace face;
  face.First = tableRecord(tableEntry());
  face.EdgeLevels = ivec3(levels.x & 15, (levels.x >> 4) & 15, (levels.x >> 8) & 15);
  face.Level = (levels.x >> 12) & 15;
  face.Reversed = levels.y;
  face.Order = ivec3(permuteWeights(vec3(0.0f, 1.0f, 2.0f), cornerOrder()));
  return face;
}

// The sorted corner that a corner of the face is.
RELEVO_FUNCTION int sortedCorner(MicroFace face, int corner)
{
  return face.Order.x == corner ? 0 : (face.Order.y == corner ? 1 : 2);
}

// The displacement is in the low 16 bits, plus 32768. The normal is in octahedral coordinates, 8
// bits each.
RELEVO_FUNCTION float sampleDisplacement(int bits)
{
  return float((bits & 65535) - 32768);
}

RELEVO_FUNCTION vec3 sampleNormal(int bits)
{
  vec2 e = vec2(float((bits >> 16) & 255), float((bits >> 24) & 255)) / 127.0f - 1.0f;
  vec3 n = vec3(e, 1.0f - abs(e.x) - abs(e.y));
  float fold = max(-n.z, 0.0f);
  n.x += n.x >= 0.0f ? -fold : fold;
  n.y += n.y >= 0.0f ? -fold : fold;
  return unitVector(n);
}

RELEVO_FUNCTION MicroPoint sampledPoint(vec3 w, int sampleIndex)
{
  int bits = tableRecord(sampleIndex >> 2)[sampleIndex & 3];
  precise vec3 direction =
    weightedSum(vec3(cornerValues(0)), vec3(cornerValues(1)), vec3(cornerValues(2)), w);
  precise vec3 position = weightedSum(cornerPoint(0), cornerPoint(1), cornerPoint(2), w);
  precise vec3 way = direction * sampleDisplacement(bits);
  way = way * surfaceScale();
  position = position + way;
  MicroPoint point;
  point.Position = position;
  point.Normal = sampleNormal(bits);
  return point;
}

// The point k of an edge with m segments from the sorted corner low to high.
RELEVO_FUNCTION MicroPoint microEdgeSample(MicroFace face, int edge, int low, int high, int k, int m)
{
  if (k <= 0 || k >= m)
  {
    int corner = k <= 0 ? low : high;
    MicroPoint point;
    point.Position = cornerPoint(corner);
    point.Normal = cornerNormal(corner);
    return point;
  }
  vec3 w = vec3(0.0f);
  w[low] = float(m - k) / float(m);
  w[high] = float(k) / float(m);
  int start = (face.Reversed >> edge & 1) != 0 ? (edge + 1) % 3 : edge;
  int place = sortedCorner(face, start) == low ? k : m - k;
  return sampledPoint(w, face.First[edge] + place - 1);
}

RELEVO_FUNCTION MicroPoint mixPoints(MicroPoint a, MicroPoint b, float share)
{
  float rest = 1.0f - share;
  precise vec3 position = a.Position * rest;
  position = position + b.Position * share;
  MicroPoint point;
  point.Position = position;
  point.Normal = a.Normal * rest + b.Normal * share;
  return point;
}

// A point of an edge. `weight` is that of the edge's higher sorted corner.
RELEVO_FUNCTION MicroPoint microEdgePoint(MicroFace face, int edge, int low, int high, float weight)
{
  int m = 1 << face.EdgeLevels[edge];
  float place = weight * float(m);
  int k = min(int(floor(place)), m - 1);
  float share = place - float(k);
  MicroPoint before = microEdgeSample(face, edge, low, high, k, m);
  if (share == 0.0f)
  {
    return before;
  }
  MicroPoint after = microEdgeSample(face, edge, low, high, k + 1, m);
  if (share == 1.0f)
  {
    return after;
  }
  return mixPoints(before, after, share);
}

// The edge on which a sorted corner has the weight 0.
RELEVO_FUNCTION MicroPoint microBorderPoint(MicroFace face, int lacking, vec3 w)
{
  int low = lacking == 0 ? 1 : 0;
  int high = lacking == 2 ? 1 : 2;
  return microEdgePoint(face, (face.Order[lacking] + 1) % 3, low, high, w[high]);
}

// A point of the face's grid, with n times the weights of the face's corners.
RELEVO_FUNCTION MicroPoint microGridPoint(MicroFace face, ivec3 grid)
{
  int n = 1 << face.Level;
  vec3 w = vec3(float(grid[face.Order.x]), float(grid[face.Order.y]), float(grid[face.Order.z])) /
    float(n);
  int lacking = w.x == 0.0f ? 0 : (w.y == 0.0f ? 1 : (w.z == 0.0f ? 2 : -1));
  if (lacking >= 0)
  {
    return microBorderPoint(face, lacking, w);
  }
  int row = grid.z - 1; // of the points inside
  int inside = row * (n - 2) - row * (row - 1) / 2 + grid.y - 1;
  return sampledPoint(w, face.First.w + inside);
}

RELEVO_FUNCTION MicroPoint microPoint(vec3 w)
{
  MicroFace face = microFace();
  int lacking = w.x == 0.0f ? 0 : (w.y == 0.0f ? 1 : (w.z == 0.0f ? 2 : -1));
  if (lacking >= 0)
  {
    return microBorderPoint(face, lacking, w);
  }
  int n = 1 << face.Level;
  float x = w[sortedCorner(face, 0)] * float(n);
  float y = w[sortedCorner(face, 1)] * float(n);
  int i = int(floor(x));
  int j = int(floor(y));
  int k = n - i - j;
  float u = x - float(i);
  float v = y - float(j);
  // The triangle at the grid point (i, j, k), or the one beside it towards the corners 0 and 1.
  bool isBeside = u + v > 1.0f && k > 1;
  if (k < 1 || (u == 0.0f && v == 0.0f))
  {
    return microGridPoint(face, ivec3(i, j, max(k, 0)));
  }
  ivec3 origin = isBeside ? ivec3(i + 1, j + 1, k - 2) : ivec3(i, j, k);
  vec2 share = isBeside ? vec2(1.0f - v, 1.0f - u) : vec2(u, v);
  MicroPoint a = microGridPoint(face, origin);
  MicroPoint b = microGridPoint(face, ivec3(i + 1, j, k - 1));
  MicroPoint c = microGridPoint(face, ivec3(i, j + 1, k - 1));
  float rest = 1.0f - share.x - share.y;
  MicroPoint point;
  point.Position = a.Position * rest + b.Position * share.x + c.Position * share.y;
  point.Normal = a.Normal * rest + b.Normal * share.x + c.Normal * share.y;
  return point;
}

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  return microPoint(w).Position;
}

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  return microPoint(w).Normal;
}

// The inputs of relevoMicroField.glsl: the record of the face, and the weights of its corners.
RELEVO_FUNCTION ivec2 surfaceFieldRecord()
{
  return ivec2(tableRecord(tableEntry() + 2).x, microFace().Level);
}

RELEVO_FUNCTION vec3 surfaceFieldWeights(vec3 w)
{
  MicroFace face = microFace();
  return vec3(w[sortedCorner(face, 0)], w[sortedCorner(face, 1)], w[sortedCorner(face, 2)]);
}
