// The small triangle of a micro-mesh's grid that contains a point of a face; for relevoMicroCells.glsl
// and relevoMicroField.glsl.

struct MicroTriangle
{
  ivec3 Origin;  // corners have one more in x, y or z
  vec2 Place;    // from the corner z, in segments towards the corners x and y
  bool IsTurned; // whether it is the triangle beside, towards the face's corners 0 and 1
};

// `w` are the weights of the face's corners.
RELEVO_FUNCTION MicroTriangle microTriangle(int level, vec3 w)
{
  int n = 1 << level;
  float x = clamp(w.x, 0.0f, 1.0f) * float(n);
  float y = clamp(w.y, 0.0f, 1.0f) * float(n);
  int i = min(int(floor(x)), n - 1);
  int j = min(int(floor(y)), n - 1 - i);
  int k = n - 1 - i - j;
  MicroTriangle triangle;
  triangle.Origin = ivec3(i, j, k);
  triangle.Place = vec2(x - float(i), y - float(j));
  triangle.IsTurned = triangle.Place.x + triangle.Place.y > 1.0f && k > 0;
  return triangle;
}
