// The triangle of a micro-mesh's grid that contains a point of a face, for values of cell arrays; see
// vtkMicroMeshSurface.

// `record` is the face's first grid point and its level; `w` are the weights of the face's corners.
// A face has 2 values per grid point, of which the first are those of its triangles, in rows from
// the edge 0.
RELEVO_FUNCTION int microCell(ivec2 record, vec3 w)
{
  int n = 1 << record.y;
  float x = clamp(w.x, 0.0f, 1.0f) * float(n);
  float y = clamp(w.y, 0.0f, 1.0f) * float(n);
  int i = min(int(floor(x)), n - 1);
  int j = min(int(floor(y)), n - 1 - i);
  int k = n - 1 - i - j;
  bool isTurned = x - float(i) + y - float(j) > 1.0f && k > 0;
  int row = isTurned ? k - 1 : k;
  return 2 * record.x + row * (2 * n - row) + 2 * j + (isTurned ? 1 : 0);
}
