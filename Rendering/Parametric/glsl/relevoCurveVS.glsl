// Runs first in main() and computes the attributes that VTK's code uses as the vertex.

uniform vec4 relevoEye; // position of the eye, 1; or the direction towards a parallel camera, 0

#ifdef RELEVO_SCALARS
vec4 relevoScalarsAt(CurveLine line, float t)
{
  return relevoScalarsAsTyped(curveValueAt(line, curveValueLine(t), t));
}

float relevoScalar(CurveLine line, float t)
{
  relevoTexel = 0;
  relevoTexels = max(relevoScalarTexels, 1);
  if (relevoScalarTexels == 0)
  {
    return relevoScalarsAt(line, t).x;
  }
  float sum = 0.0;
  for (; relevoTexel < relevoTexels; ++relevoTexel)
  {
    vec4 scalars = relevoScalarsAt(line, t);
    sum += dot(scalars, scalars);
  }
  return sqrt(sum);
}
#endif

#ifdef RELEVO_CELL_COLORS
// per curve: red, green, blue, opacity, from the lowest byte
uniform usamplerBuffer relevoCellColors;

vec4 relevoCellColor()
{
  uint color = texelFetch(relevoCellColors, relevoCurve).r;
  return vec4(uvec4(color, color >> 8, color >> 16, color >> 24) & 255u) / 255.0;
}
#endif

#if RELEVO_SIDES > 1
uniform float relevoRadius;

// Return the radius and its derivative by arc length.
vec2 relevoRadiusAt(CurveLine line, float t)
{
#ifdef RELEVO_RADII
  relevoTexels = 0;
  CurveValueLine values = curveValueLine(t);
  return vec2(curveValueAt(line, values, t).x, curveSlope(line, values).x);
#else
  return vec2(relevoRadius, 0.0);
#endif
}
#endif

void relevoSetColor(CurveLine line, float t)
{
#if defined(RELEVO_CELL_COLORS)
  relevoColorVSOutput = relevoCellColor();
#elif defined(RELEVO_POINT_COLORS)
  relevoTexels = 1;
  relevoColorVSOutput = clamp(curveValueAt(line, curveValueLine(t), t) / 255.0, 0.0, 1.0);
#elif defined(RELEVO_SCALARS_OF_FRAGMENTS)
  relevoScalarVSOutput = relevoScalar(line, t);
#elif defined(RELEVO_SCALARS)
  relevoColorVSOutput = relevoTableColor(relevoScalar(line, t));
#endif
}

void relevoDrawCurve()
{
  relevoPlaceVertex();
#if RELEVO_SIDES > 2
  // The rings are the centre of a cap, its rim, the rings of the tube, and the rim and centre of
  // the other cap.
  int ring = clamp(relevoRing - 2, 0, relevoGroup.w);
#else
  int ring = relevoRing;
#endif
  precise float t = float(ring) / float(relevoGroup.w);
  CurveLine line = curveLine(t);
  precise vec3 position = curvePosition(line, t);
  vec3 toEye = relevoEye.xyz - position * relevoEye.w;
  vec3 normal;
#if RELEVO_SIDES == 1
  // Of the normals across the curve, use the one that faces the eye most.
  vec3 tangent = curveTangent(line, t);
  normal = toEye - dot(toEye, tangent) * tangent;
  normal = dot(normal, normal) > 0.0 ? normalize(normal) : toEye;
#else
  vec3 tangent = curveFrameTangent(line, t);
  vec3 frame = curveFrameNormal(tangent, t);
  vec2 radius = relevoRadiusAt(line, t);
#if RELEVO_SIDES == 2
  vec3 side = ribbonSide(tangent, frame, toEye);
  position += (relevoSide == 0 ? -radius.x : radius.x) * side;
  normal = ribbonNormal(tangent, side);
#else
  float angle = 6.28318530718 * float(relevoSide) / float(RELEVO_SIDES);
  vec3 direction = tubeDirection(tangent, frame, vec2(cos(angle), sin(angle)));
  bool atEnd = relevoRing > relevoGroup.w + 2;
  bool isCap = relevoRing < 2 || atEnd;
  bool isMiddle = relevoRing == 0 || relevoRing == relevoGroup.w + 4;
  normal = isCap ? (atEnd ? tangent : -tangent) : tubeNormal(tangent, direction, radius.y);
  // If another curve continues, the caps are degenerate.
  position += isMiddle && relevoIsOpen(atEnd) ? vec3(0.0) : radius.x * direction;
#endif
#endif
  vertexMC = vec4(position, 1.0);
  relevoSetNormal(normal);
  relevoSetColor(line, t);
#ifdef RELEVO_CELLS
  relevoCellVSOutput = int(texelFetch(relevoCells, relevoCurve).r);
#endif
}
