// A base surface displaced along its interpolated normals by a height function
// (Lenz 2009, section 5.4): V = B + amplitude h N, with N = N0 w0 + N1 w1 + N2 w2, which is not
// normalised and at most 1 long. The including code provides relevoWeights.glsl,
// relevoDisplacedNormal.glsl, relevoProceduralValues.glsl and
//   vec3 basePosition(vec3 w), vec3 baseNormal(vec3 w)      the base surface
//   vec3 cornerPoint(int i), vec3 cornerDirection(int i)    corners sorted
//   vec3 surfaceScale(), vec3 modelPosition(vec3)           see vtkRefinementSurface.h
//   float proceduralHeight(vec3 position, vec3 normal, vec3 weights)
//   HeightGradient proceduralGradient(vec3 position, vec3 normal, vec3 weights)

// On the border, weights of 0 are passed, so that the function has the same value from both sides.
RELEVO_FUNCTION vec3 innerWeights(vec3 w)
{
  return w.x == 0.0f || w.y == 0.0f || w.z == 0.0f ? vec3(0.0f) : w;
}

RELEVO_FUNCTION vec3 proceduralDirection(vec3 w)
{
  return weightedSum(cornerDirection(0), cornerDirection(1), cornerDirection(2), w);
}

RELEVO_FUNCTION vec3 surfacePosition(vec3 w)
{
  vec3 base = basePosition(w);
  vec3 direction = proceduralDirection(w);
  float height = proceduralHeight(modelPosition(base), unitVector(direction), innerWeights(w));
  // Heights are limited to the range of the bounds, and NaN is replaced by 0.
  if (!(abs(height) <= 1.0f))
  {
    height = height > 0.0f ? 1.0f : (height < 0.0f ? -1.0f : 0.0f);
  }
  precise vec3 p = base + direction * (relevoAmplitude * height) * surfaceScale();
  return p;
}

RELEVO_FUNCTION vec3 surfaceNormal(vec3 w)
{
  vec3 normal = unitVector(baseNormal(w));
  vec3 direction = proceduralDirection(w);
  vec3 inner = innerWeights(w);
  HeightGradient height =
    proceduralGradient(modelPosition(basePosition(w)), unitVector(direction), inner);
  vec3 gradient = height.ByPosition;
  if (inner != vec3(0.0f))
  {
    // The gradient of a weight on the coarse triangle is the direction of the triangle's height
    // over its length.
    vec3 p0 = cornerPoint(0) / surfaceScale();
    vec3 p1 = cornerPoint(1) / surfaceScale();
    vec3 p2 = cornerPoint(2) / surfaceScale();
    vec3 area = cross(p1 - p0, p2 - p0);
    vec3 sum = cross(area, p2 - p1) * height.ByWeights.x + cross(area, p0 - p2) * height.ByWeights.y +
      cross(area, p1 - p0) * height.ByWeights.z;
    gradient += sum / max(dot(area, area), 1e-30f);
  }
  vec3 displaced = displacedNormal(normal, direction, relevoAmplitude * gradient, 1.0f);
  // An unbounded function has no normals.
  return dot(displaced, displaced) < 1e30f ? displaced : normal;
}
