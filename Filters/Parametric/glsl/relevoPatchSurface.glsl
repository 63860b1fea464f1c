// Faces that are parts of Bezier patches; see vtkPatchSurface. The including file provides
// relevoWeights.glsl, relevoPatch.glsl, the corner functions of vtkRefinementSurface.h and its
// tables:
//
//   int tableEntry()           the face's first record
//   int cornerOrder()          permutation from the face's corners to the sorted ones
//   vec4 tablePoint(int i)     a control point and its weight
//   ivec4 tableRecord(int i)   four per face:
//     0: the patch, see unpackShape(); a bit for each edge that degenerates to a point
//     1: the corners' u << 16 | v, in multiples of 1 / patchUnit
//     2, 3: a face at each edge, the same two for all faces at it: record << 3 | edge << 1 | 1 if
//        that face passes the edge from its higher merged point to the lower; -1 for none
//
// Edge k connects corners k and k + 1 of the face.

vec3 patchOrigin = vec3(0.0f); // control points are relative to it, for precision

RELEVO_FUNCTION vec4 patchPoint(int i)
{
  vec4 point = tablePoint(i);
  return vec4((vec3(point) - patchOrigin) * point.w, point.w);
}

struct FacePatch
{
  PatchShape Shape;
  int PointEdges; // a bit for each edge that degenerates to a point
  ivec3 Corners;  // of the sorted corners
  ivec3 Order;    // corners of the face that these are
};

RELEVO_FUNCTION FacePatch facePatch()
{
  ivec4 record = tableRecord(tableEntry());
  ivec4 corners = tableRecord(tableEntry() + 1);
  FacePatch face;
  face.Shape = unpackShape(ivec2(record));
  face.PointEdges = record.z;
  face.Order = ivec3(permuteWeights(vec3(0.0f, 1.0f, 2.0f), cornerOrder()));
  face.Corners = ivec3(corners[face.Order.x], corners[face.Order.y], corners[face.Order.z]);
  return face;
}

RELEVO_FUNCTION ivec2 unpackCorner(int corner)
{
  return ivec2(corner >> 16, corner & 65535);
}

RELEVO_FUNCTION vec2 cornerCoordinate(int corner)
{
  return vec2(unpackCorner(corner)) / float(patchUnit);
}

// Interpolates the patch parameters with weights of the sorted corners.
RELEVO_FUNCTION vec2 patchCoordinate(FacePatch face, vec3 w)
{
  return weightedSum(cornerCoordinate(face.Corners.x), cornerCoordinate(face.Corners.y),
    cornerCoordinate(face.Corners.z), w);
}

// Returns the sorted corner with weight 1, or -1.
RELEVO_FUNCTION int loneCorner(vec3 w)
{
  if (w.y == 0.0f && w.z == 0.0f)
  {
    return 0;
  }
  return w.x != 0.0f ? -1 : (w.z == 0.0f ? 1 : (w.y == 0.0f ? 2 : -1));
}

// The edge that contains the weights, between sorted corners.
struct FaceEdge
{
  int Own; // edge of the face; -1 for none
  int Low;
  int High;
};

RELEVO_FUNCTION FaceEdge edgeAt(FacePatch face, vec3 w)
{
  int lacking = w.x == 0.0f ? 0 : (w.y == 0.0f ? 1 : (w.z == 0.0f ? 2 : -1));
  FaceEdge edge;
  edge.Own = lacking < 0 ? -1 : (face.Order[max(lacking, 0)] + 1) % 3;
  edge.Low = lacking == 0 ? 1 : 0;
  edge.High = lacking == 2 ? 1 : 2;
  return edge;
}

RELEVO_FUNCTION bool isPointEdge(FacePatch face, FaceEdge edge)
{
  return edge.Own >= 0 && (face.PointEdges >> edge.Own & 1) != 0;
}

RELEVO_FUNCTION vec3 borderPosition(PatchShape shape, int border, ivec2 ends, int low, float weight)
{
  bool isReversed = ends.x > ends.y;
  ivec2 forward = isReversed ? ivec2(patchUnit) - ends : ends;
  vec2 t = vec2(forward) / float(patchUnit);
  precise float along = t.x + (t.y - t.x) * weight;
  patchOrigin = cornerPoint(low);
  vec4 point = patchBorderPointAt(patchBorder(shape, border), isReversed, along);
  precise vec3 position = vec3(point) / point.w;
  position = position + patchOrigin;
  return position;
}

// Cache of the last point inside of a patch, because position and normal both use it.
int lastFirst = -1;
vec2 lastCoordinate = vec2(0.0f);
PatchPoint lastPoint;

RELEVO_FUNCTION PatchPoint pointInside(PatchShape shape, vec2 uv)
{
  if (lastFirst != shape.First || lastCoordinate != uv)
  {
    patchOrigin = vec3(tablePoint(shape.First));
    lastPoint = patchPointAt(shape, uv);
    lastFirst = shape.First;
    lastCoordinate = uv;
  }
  return lastPoint;
}

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  int lone = loneCorner(w);
  if (lone >= 0)
  {
    return cornerPoint(lone);
  }
  FacePatch face = facePatch();
  FaceEdge edge = edgeAt(face, w);
  if (isPointEdge(face, edge))
  {
    return cornerPoint(edge.Low);
  }
  if (edge.Own >= 0)
  {
    ivec2 low = unpackCorner(face.Corners[edge.Low]);
    ivec2 high = unpackCorner(face.Corners[edge.High]);
    int border = findPatchBorder(face.Shape, low, high);
    if (border >= 0)
    {
      ivec2 ends = ivec2(alongPatchBorder(face.Shape, border, low),
        alongPatchBorder(face.Shape, border, high));
      return borderPosition(face.Shape, border, ends, edge.Low, w[edge.High]);
    }
  }
  vec4 point = pointInside(face.Shape, patchCoordinate(face, w)).Point;
  precise vec3 position = vec3(point) / point.w;
  position = position + vec3(tablePoint(face.Shape.First));
  return position;
}

// Returns the normalized cross product of the derivatives; zero if they are parallel.
RELEVO_FUNCTION vec3 normalInside(PatchShape shape, vec2 uv)
{
  PatchPoint at = pointInside(shape, uv);
  vec3 position = vec3(at.Point) / at.Point.w;
  vec3 byU = (vec3(at.ByU) - position * at.ByU.w) / surfaceScale();
  vec3 byV = (vec3(at.ByV) - position * at.ByV.w) / surfaceScale();
  vec3 larger = max(abs(byU), abs(byV));
  float largest = max(max(larger.x, larger.y), larger.z);
  if (!(largest > 0.0f))
  {
    return vec3(0.0f);
  }
  vec3 normal = cross(byU / largest, byV / largest);
  const float least = 1e-4f; // smaller values are rounding errors
  return dot(normal, normal) > least * least ? unitVector(normal) : vec3(0.0f);
}

// Returns the normal. Where derivatives vanish, as at a degenerate edge, this is the limit from the
// interior of the patch.
RELEVO_FUNCTION vec3 patchNormal(PatchShape shape, vec2 uv)
{
  vec3 normal = normalInside(shape, uv);
  if (normal == vec3(0.0f))
  {
    vec2 middle = vec2(shape.IsTriangle ? 1.0f / 3.0f : 0.5f);
    vec3 beside = normalInside(shape, mix(uv, middle, 1.0f / 256.0f));
    vec3 beyond = normalInside(shape, mix(uv, middle, 1.0f / 128.0f));
    normal = unitVector(2.0f * beside - beyond);
  }
  return normal;
}

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  FacePatch face = facePatch();
  vec3 normal = patchNormal(face.Shape, patchCoordinate(face, w));
  return normal == vec3(0.0f)
    ? weightedSum(cornerNormal(0), cornerNormal(1), cornerNormal(2), w)
    : normal;
}

// Returns the normal of one of the faces at an edge, at a weight of the edge's higher end.
RELEVO_FUNCTION vec3 normalOfFaceAt(int reference, float weight)
{
  if (reference < 0)
  {
    return vec3(0.0f);
  }
  int entry = reference >> 3;
  int edge = (reference >> 1) & 3;
  ivec4 corners = tableRecord(entry + 1);
  vec2 from = cornerCoordinate(corners[edge]);
  vec2 to = cornerCoordinate(corners[(edge + 1) % 3]);
  bool descends = (reference & 1) != 0;
  return patchNormal(unpackShape(ivec2(tableRecord(entry))),
    descends ? mix(to, from, weight) : mix(from, to, weight));
}

// Returns the direction of displacement: the normal. On edges between patches it is the mean
// normal, and at corners the mean of all adjacent faces, so that the displaced surface has no
// cracks.
RELEVO_FUNCTION vec3 surfaceDirection(vec3 w)
{
  int lone = loneCorner(w);
  if (lone >= 0)
  {
    return cornerDirection(lone);
  }
  FaceEdge edge = edgeAt(facePatch(), w);
  if (isPointEdge(facePatch(), edge))
  {
    return cornerDirection(edge.Low);
  }
  int first = edge.Own < 0 ? -1 : tableRecord(tableEntry() + 2)[edge.Own];
  if (first < 0)
  {
    return surfaceNormal(w);
  }
  vec3 one = normalOfFaceAt(first, w[edge.High]);
  vec3 sum = one + normalOfFaceAt(tableRecord(tableEntry() + 3)[edge.Own], w[edge.High]);
  return dot(sum, sum) > 1e-6f ? sum : one;
}
