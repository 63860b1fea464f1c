// The values of cell arrays of a micro-mesh, one per triangle of its grids; see vtkMicroMeshSurface.
// The including file provides relevoMicroTriangle.glsl.

// `record` is the face's first grid point and its level; `w` are the weights of the face's corners.
// A face has 2 values per grid point, of which the first are those of its triangles, in rows from
// the edge 0.
RELEVO_FUNCTION int microCell(ivec2 record, vec3 w)
{
  MicroTriangle triangle = microTriangle(record.y, w);
  int n = 1 << record.y;
  int row = triangle.IsTurned ? triangle.Origin.z - 1 : triangle.Origin.z;
  return 2 * record.x + row * (2 * n - row) + 2 * triangle.Origin.y + (triangle.IsTurned ? 1 : 0);
}
