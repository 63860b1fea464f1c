// Scalars that are interpolated over the refined surface and then mapped to colours. Follows
// relevoScalars.glsl.

bool relevoIsCorner(vec3 w)
{
  return max(w.x, max(w.y, w.z)) == 1.0;
}

// A corner with weight 0 is ignored, even if it is NaN.
vec4 relevoScalarsAt(int corner, float weight, int k)
{
  return weight == 0.0
    ? vec4(0.0)
    : texelFetch(relevoScalars, relevoFace[corner] * max(relevoScalarTexels, 1) + k);
}

vec4 relevoScalarsOf(vec3 w, int k)
{
  return relevoScalarsAsTyped(weightedSum(
    relevoScalarsAt(0, w.x, k), relevoScalarsAt(1, w.y, k), relevoScalarsAt(2, w.z, k), w));
}

// Values that cannot be interpolated, such as strings, are those of the nearest corner; see
// RefinedPoint.
int relevoNearestCorner(vec3 w)
{
  int first = w.y > w.x ? 1 : 0;
  return w.z > w[first] ? 2 : first;
}

float relevoScalar(vec3 w)
{
#ifdef RELEVO_NO_DATA
  vec3 none = relevoNoDataWeights(w);
  if (none != vec3(0.0))
  {
    if (relevoScalarsAreIntegers == 0)
    {
      return relevoNotANumber;
    }
    // Whole numbers have no NaN, so the no-data value itself is used.
    int corner = relevoNearestCorner(none);
    w = vec3(corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0);
  }
#endif
  if (relevoScalarTexels == 0)
  {
    return relevoScalarsOf(w, 0).x;
  }
  float sum = 0.0;
  for (int k = 0; k < relevoScalarTexels; ++k)
  {
    vec4 scalars = relevoScalarsOf(w, k);
    sum += dot(scalars, scalars);
  }
  return sqrt(sum);
}

#ifdef RELEVO_SCALARS
vec4 relevoScalarColor(vec3 w)
{
  return relevoTableColor(relevoScalar(w));
}
#endif

vec2 relevoScalarCoordinate(vec3 w)
{
  return relevoTextureCoordinate(relevoScalar(w));
}
