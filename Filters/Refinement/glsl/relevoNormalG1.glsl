// Normals of the patch in relevoG1Triangle.glsl, not normalised. On edges, they are those of the
// shared tangent planes, computed from data of the edge. Inside, they are the cross product of the
// derivatives. The including code provides the requirements of relevoG1Triangle.glsl, vec3
// surfaceScale(),
//   vec3 cornerNormal(int)
//   vec3 edgeVector(edge, 2 to 4)  the Bezier points of the field A across the edge

// Replaces a normal that is too short, by that of the corners.
RELEVO_FUNCTION vec3 normalOr(vec3 normal, vec3 instead, float least)
{
  float largest = max(max(abs(normal.x), abs(normal.y)), abs(normal.z));
  return largest > least ? normal : instead;
}

// On the edge from sorted corner `first` to `second`, at weights s and t.
RELEVO_FUNCTION vec3 edgeNormal(int edge, int first, int second, float s, float t)
{
  float ss = s * s;
  float st = 2.0f * s * t;
  float tt = t * t;
  precise vec3 along = (edgeVector(edge, 0) - cornerPoint(first)) * ss;
  along += (edgeVector(edge, 1) - edgeVector(edge, 0)) * st;
  along += (cornerPoint(second) - edgeVector(edge, 1)) * tt;
  along = along / surfaceScale();
  precise vec3 across = edgeVector(edge, 2) * ss;
  across += edgeVector(edge, 3) * st;
  across += edgeVector(edge, 4) * tt;
  precise vec3 normal = cross(along, across);
  precise vec3 interpolated = cornerNormal(first) * s;
  interpolated += cornerNormal(second) * t;
  return normalOr(normal, interpolated, 0.0f);
}

RELEVO_FUNCTION vec3 innerNormal(vec3 w)
{
  // Points are relative to a corner, so that differences of points far from the origin keep their
  // precision.
  vec3 origin = cornerPoint(0);
  vec3 b030 = cornerPoint(1) - origin;
  vec3 b003 = cornerPoint(2) - origin;
  vec3 b210 = edgeVector(0, 0) - origin;
  vec3 b120 = edgeVector(0, 1) - origin;
  vec3 b021 = edgeVector(1, 0) - origin;
  vec3 b012 = edgeVector(1, 1) - origin;
  vec3 b201 = edgeVector(2, 0) - origin;
  vec3 b102 = edgeVector(2, 1) - origin;
  vec3 c0 = innerPoint0(w) - origin;
  vec3 c1 = innerPoint1(w) - origin;
  vec3 c2 = innerPoint2(w) - origin;
  vec3 b111 = weightedSum(c0, c1, c2, w);

  // The centre's derivatives with respect to each weight.
  float x = w.x / (w.y + w.z);
  float y = w.y / (w.x + w.z);
  float z = w.z / (w.x + w.y);
  vec3 by0 = c0 + (faceVector(1) - origin - c1) * y + (faceVector(5) - origin - c2) * z;
  vec3 by1 = c1 + (faceVector(0) - origin - c0) * x + (faceVector(3) - origin - c2) * z;
  vec3 by2 = c2 + (faceVector(4) - origin - c0) * x + (faceVector(2) - origin - c1) * y;

  // The last three points of de Casteljau's algorithm. Their differences are the derivatives of the
  // cubic patch with this centre, up to a factor of 3.
  vec3 squares = w * w;
  vec3 products = 2.0f * vec3(w.x * w.y, w.y * w.z, w.x * w.z); // 01, 12, 02
  vec3 last0 = b210 * products.x + b201 * products.z + b120 * squares.y + b111 * products.y +
    b102 * squares.z;
  vec3 last1 = b210 * squares.x + b120 * products.x + b111 * products.z + b030 * squares.y +
    b021 * products.y + b012 * squares.z;
  vec3 last2 = b201 * squares.x + b111 * products.x + b102 * products.z + b021 * squares.y +
    b012 * products.y + b003 * squares.z;

  float moving = 2.0f * w.x * w.y * w.z;
  vec3 tangent1 = last1 - last0 + (by1 - by0) * moving;
  vec3 tangent2 = last2 - last0 + (by2 - by0) * moving;
  vec3 normal =
    cross(unitVector(tangent1 / surfaceScale()), unitVector(tangent2 / surfaceScale()));
  vec3 interpolated = weightedSum(cornerNormal(0), cornerNormal(1), cornerNormal(2), w);
  normal = normalOr(normal, interpolated, 1e-6f); // smaller values are rounding errors
  return dot(normal, interpolated) < 0.0f ? -normal : normal;
}

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  if (w.x > 0.0f && w.y > 0.0f && w.z > 0.0f)
  {
    return innerNormal(w);
  }
  // One call for all three edges, so that compilers generate the same operations.
  int edge = w.z == 0.0f ? 0 : (w.x == 0.0f ? 1 : 2);
  int first = edge == 1 ? 1 : 0;
  int second = edge == 0 ? 1 : 2;
  float s = edge == 1 ? w.y : w.x;
  float t = edge == 0 ? w.y : w.z;
  if (s == 0.0f || t == 0.0f)
  {
    return s == 0.0f ? cornerNormal(second) : cornerNormal(first);
  }
  return edgeNormal(edge, first, second, s, t);
}
