// The triangle of a micro-mesh's grid that contains a point of a face, for values of point arrays at
// grid points; see vtkMicroMeshSurface.

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
  int n = 1 << record.y;
  float x = clamp(w.x, 0.0f, 1.0f) * float(n);
  float y = clamp(w.y, 0.0f, 1.0f) * float(n);
  int i = min(int(floor(x)), n - 1);
  int j = min(int(floor(y)), n - 1 - i);
  int k = n - 1 - i - j;
  float u = x - float(i);
  float v = y - float(j);
  ivec3 a = ivec3(i + 1, j, k);
  ivec3 b = ivec3(i, j + 1, k);
  ivec3 c = ivec3(i, j, k + 1);
  FieldPlace place;
  place.Weights = vec3(u, v, 1.0f - u - v);
  if (u + v > 1.0f && k > 0) // the triangle beside it, towards the corners 0 and 1
  {
    a = ivec3(i, j + 1, k);
    b = ivec3(i + 1, j, k);
    c = ivec3(i + 1, j + 1, k - 1);
    place.Weights = vec3(1.0f - u, 1.0f - v, u + v - 1.0f);
  }
  place.Indices = record.x + ivec3(microGridIndex(n, a), microGridIndex(n, b), microGridIndex(n, c));
  return place;
}
