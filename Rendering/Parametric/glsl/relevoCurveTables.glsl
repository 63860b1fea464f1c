// The inputs of relevoCurve.glsl and the files that follow it.

uniform samplerBuffer relevoControlPoints; // three floats, or four if weights differ
int relevoCurve;
int relevoFirstPoint;

#ifdef RELEVO_DEGREE
int curveDegree()
{
  return RELEVO_DEGREE;
}

void relevoTakeCurve(int curve)
{
  relevoCurve = curve;
  relevoFirstPoint = curve * (RELEVO_DEGREE + 1);
}
#else
uniform usamplerBuffer relevoCurves; // first control point << 3 | degree - 1
int relevoDegree = 1;

int curveDegree()
{
  return relevoDegree;
}

void relevoTakeCurve(int curve)
{
  uint record = texelFetch(relevoCurves, curve).r;
  relevoCurve = curve;
  relevoFirstPoint = int(record >> 3);
  relevoDegree = int(record & 7u) + 1;
}
#endif

vec4 curvePoint(int i)
{
  vec4 point = texelFetch(relevoControlPoints, relevoFirstPoint + i);
#ifdef RELEVO_RATIONAL
  return point;
#else
  return vec4(point.xyz, 1.0);
#endif
}

#ifdef RELEVO_FRAMES
// per curve: first station << 5 | open at its start << 4 | open at its end << 3 | logarithm of the
// number of intervals
uniform usamplerBuffer relevoFrames;
uniform samplerBuffer relevoStations; // tangent and normal of each station

int curveIntervals()
{
  return 1 << int(texelFetch(relevoFrames, relevoCurve).r & 7u);
}

int relevoStation(int k)
{
  return 2 * (int(texelFetch(relevoFrames, relevoCurve).r >> 5) + k);
}

vec3 curveStationTangent(int k)
{
  return texelFetch(relevoStations, relevoStation(k)).xyz;
}

vec3 curveStationNormal(int k)
{
  return texelFetch(relevoStations, relevoStation(k) + 1).xyz;
}

bool relevoIsOpen(bool atEnd)
{
  return (texelFetch(relevoFrames, relevoCurve).r >> (atEnd ? 3 : 4) & 1u) == 1u;
}
#endif

#ifdef RELEVO_VALUES
// The table that values come from: radii if there are no texels, otherwise scalars, and the index
// of the point's texel.
int relevoTexels = 0;
int relevoTexel = 0;
#ifdef RELEVO_RADII
uniform samplerBuffer relevoRadii;
#endif

vec4 curveValue(int i)
{
  int point = relevoFirstPoint + i;
#if defined(RELEVO_RADII) && defined(RELEVO_SCALARS)
  return relevoTexels == 0 ? texelFetch(relevoRadii, point)
                           : texelFetch(relevoScalars, point * relevoTexels + relevoTexel);
#elif defined(RELEVO_RADII)
  return texelFetch(relevoRadii, point);
#else
  return texelFetch(relevoScalars, point * relevoTexels + relevoTexel);
#endif
}
#endif
