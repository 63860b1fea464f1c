// The values of point arrays of a micro-mesh, at its grid points; see vtkMicroMeshSurface. The including
// file provides relevoMicroTriangle.glsl.

struct FieldPlace
{
  ivec3 Indices; // of values
  vec3 Weights;
};

// The index of a grid point in rows of equal z, each in the order of increasing y.
RELEVO_FUNCTION int microGridIndex(int n, ivec3 grid)
{
  return grid.z * (n + 1) - grid.z * (grid.z - 1) / 2 + grid.y;
}

// `record` is the first value of the face and its level; `w` are the weights of the face's corners.
RELEVO_FUNCTION FieldPlace fieldPlace(ivec2 record, vec3 w)
{
  MicroTriangle triangle = microTriangle(record.y, w);
  int n = 1 << record.y;
  int i = triangle.Origin.x;
  int j = triangle.Origin.y;
  int k = triangle.Origin.z;
  float u = triangle.Place.x;
  float v = triangle.Place.y;
  ivec3 a = ivec3(i + 1, j, k);
  ivec3 b = ivec3(i, j + 1, k);
  ivec3 c = ivec3(i, j, k + 1);
  FieldPlace place;
  place.Weights = vec3(u, v, 1.0f - u - v);
  if (triangle.IsTurned)
  {
    a = ivec3(i, j + 1, k);
    b = ivec3(i + 1, j, k);
    c = ivec3(i + 1, j + 1, k - 1);
    place.Weights = vec3(1.0f - u, 1.0f - v, u + v - 1.0f);
  }
  place.Indices = record.x + ivec3(microGridIndex(n, a), microGridIndex(n, b), microGridIndex(n, c));
  return place;
}
