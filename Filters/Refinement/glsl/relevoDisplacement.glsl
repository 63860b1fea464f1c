// Displacement by heights: S = B + h D, with h = offset + scale * height and D a unit direction.
// Shared by the shaders and C++.
//
// The including code provides relevoHeight.glsl, relevoWeights.glsl, relevoDisplacedNormal.glsl and
//   float displacementScale(), float displacementOffset()
//   bool displacementAlongNormal()       whether D is the normal
//   vec3 displacementDirection(vec3 w, vec3 unitNormal)  D
//   int cornerId(int i)                  the point id of a sorted corner
//   bool hasSeams(), int seamPoint(int)  see RefinementMesh::Seams
//   vec2 pointTextureCoordinate(int id), vec4 pointFrame(int id, int k)
//                                        see RefinementMesh::Frames

struct DisplacedPoint
{
  vec3 Vector; // to add to the position
  vec3 Normal; // of the displaced surface, not normalised
};

// The points whose texture coordinates are used for the height at w. Inside a face, they are its
// corners. On the border, all adjacent faces use the same points, so that a point on a seam has one
// height.
RELEVO_FUNCTION ivec3 heightPoints(vec3 w)
{
  ivec3 points = ivec3(cornerId(0), cornerId(1), cornerId(2));
  if (hasSeams())
  {
    if (w.x == 0.0f && w.y == 0.0f)
    {
      points.z = seamPoint(2);
    }
    else if (w.x == 0.0f && w.z == 0.0f)
    {
      points.y = seamPoint(1);
    }
    else if (w.y == 0.0f && w.z == 0.0f)
    {
      points.x = seamPoint(0);
    }
    else if (w.z == 0.0f)
    {
      points.x = seamPoint(3);
      points.y = seamPoint(6);
    }
    else if (w.x == 0.0f)
    {
      points.y = seamPoint(4);
      points.z = seamPoint(7);
    }
    else if (w.y == 0.0f)
    {
      points.x = seamPoint(5);
      points.z = seamPoint(8);
    }
  }
  return points;
}

RELEVO_FUNCTION vec2 heightCoordinate(ivec3 points, vec3 w)
{
  return weightedSum(pointTextureCoordinate(points.x), pointTextureCoordinate(points.y),
    pointTextureCoordinate(points.z), w);
}

RELEVO_FUNCTION DisplacedPoint displace(vec3 w, vec3 normal)
{
  vec3 unitNormal = unitVector(normal);
  vec3 direction = displacementDirection(w, unitNormal);
  ivec3 points = heightPoints(w);
  vec2 uv = heightCoordinate(points, w);
  vec3 heightSample = heightAndGradientAt(uv);
  float height = displacementOffset() + displacementScale() * heightSample.x;
  vec2 slope = displacementScale() * vec2(heightSample.y, heightSample.z);
  vec4 frameU = weightedSum(
    pointFrame(points.x, 0), pointFrame(points.y, 0), pointFrame(points.z, 0), w);
  vec4 frameV = weightedSum(
    pointFrame(points.x, 1), pointFrame(points.y, 1), pointFrame(points.z, 1), w);
  vec3 gradient = vec3(frameU) * slope.x + vec3(frameV) * slope.y;
  float stretch = displacementAlongNormal() ? 1.0f + height * frameU.w : 1.0f;

  DisplacedPoint point;
  point.Vector = direction * height;
  point.Normal = displacedNormal(unitNormal, direction, gradient, stretch);
  return point;
}
