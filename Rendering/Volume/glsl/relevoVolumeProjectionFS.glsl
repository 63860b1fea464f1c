//VTK::System::Dec
//VTK::Output::Dec
#define RELEVO_FUNCTION
//RELEVO::Defines
// The colour of a pixel's ray inside a tetrahedron. The ray crosses the two faces whose projected
// edges wind around it.
//
// M. Weiler, M. Kraus, M. Merz, T. Ertl, "Hardware-Based View-Independent Cell Projection", IEEE
// Transactions on Visualization and Computer Graphics 2003, with edge tests instead of planes.

//RELEVO::Ray
//RELEVO::Edges
//RELEVO::Functions
//RELEVO::Part
//RELEVO::Blend
//RELEVO::Store

// The inputs are described in relevoVolumeProjectionVS.glsl.
#if RELEVO_SEEN_PIECE
flat in vec2 seenPiece;
#endif
flat in vec4 seenX;
flat in vec4 seenY;
flat in vec4 seenDepth;
flat in vec4 seenWeight;
#if RELEVO_CELL_SCALARS || RELEVO_COMPONENTS == 1
flat in vec4 seenScalars;
#else
flat in vec4 scalarsA;
flat in vec4 scalarsB;
flat in vec4 scalarsC;
flat in vec4 scalarsD;
#endif

#if RELEVO_STEEPNESS
flat in Scalars seenSteepness;
#endif
#if RELEVO_LIT
flat in uvec4 seenIds;
#endif

uniform sampler2D rayLimits; // from relevoVolumeLimitsFS.glsl

Scalars getScalars(vec4 weights, float inverse)
{
#if RELEVO_CELL_SCALARS && RELEVO_COMPONENTS == 1
  return seenScalars.r;
#elif RELEVO_CELL_SCALARS
  return seenScalars;
#elif RELEVO_COMPONENTS == 1
  return inverse * dot(weights, seenScalars);
#else
  return inverse *
    (weights.x * scalarsA + weights.y * scalarsB + weights.z * scalarsC + weights.w * scalarsD);
#endif
}

// Coordinates across the ray, and along it.
vec4 cornersX;
vec4 cornersY;
vec4 cornersDepth;

void findCorners()
{
#if RELEVO_CUT_BY_NEAR
  initializeLine();
  float speed = length(rayDirection);
  initializeRay();
  for (int i = 0; i < 4; ++i)
  {
    vec3 at = seenAlongRay(vec3(seenX[i], seenY[i], seenDepth[i]));
    cornersX[i] = at.x;
    cornersY[i] = at.y;
    cornersDepth[i] = at.z / speed;
  }
#else
  cornersX = seenX - vec4(gl_FragCoord.x);
  cornersY = seenY - vec4(gl_FragCoord.y);
  cornersDepth = seenDepth;
#endif
}

// The points are in the order of their ids.
float areaOf(int a, int b, out bool left)
{
  vec2 first = vec2(cornersX[a], cornersY[a]);
  vec2 last = vec2(cornersX[b], cornersY[b]);
  float area = spannedArea(uint(a), first, uint(b), last);
  left = isOnLeft(area, uint(a), first, uint(b), last);
  return abs(area);
}

// Compute the weights of the corners where the ray crosses two faces, and the inverses of their
// sums. Return false if it misses.
bool findWeights(out vec4 first, out vec4 last, out vec2 inverse)
{
  bool left01;
  bool left02;
  bool left03;
  bool left12;
  bool left13;
  bool left23;
  float area01 = areaOf(0, 1, left01);
  float area02 = areaOf(0, 2, left02);
  float area03 = areaOf(0, 3, left03);
  float area12 = areaOf(1, 2, left12);
  float area13 = areaOf(1, 3, left13);
  float area23 = areaOf(2, 3, left23);
  bool isIn0 = left12 == left23 && left12 != left13;
  bool isIn1 = left02 == left23 && left02 != left03;
  bool isIn2 = left01 == left13 && left01 != left03;
  bool isIn3 = left01 == left12 && left01 != left02;
  vec4 face0 = vec4(0.0, area23, area13, area12);
  vec4 face1 = vec4(area23, 0.0, area03, area02);
  vec4 face2 = vec4(area13, area03, 0.0, area01);
  vec4 face3 = vec4(area12, area02, area01, 0.0);
  first = seenWeight * (isIn0 ? face0 : isIn1 ? face1 : face2);
  last = seenWeight * (isIn3 ? face3 : isIn2 ? face2 : face1);
  vec2 sums = vec2(dot(first, vec4(1.0)), dot(last, vec4(1.0)));
  inverse = vec2(1.0) / sums;
  return int(isIn0) + int(isIn1) + int(isIn2) + int(isIn3) == 2 && min(sums.x, sums.y) > 0.0;
}

#if RELEVO_LIT
// Compute the gradients where the ray crosses a face; the opposite corner has weight 0.
void findGradients(vec4 weights)
{
  if (weights.x == 0.0)
  {
    walkToGradients(seenIds.yzw, weights.yzw);
  }
  else if (weights.y == 0.0)
  {
    walkToGradients(seenIds.xzw, weights.xzw);
  }
  else if (weights.z == 0.0)
  {
    walkToGradients(seenIds.xyw, weights.xyw);
  }
  else
  {
    walkToGradients(seenIds.xyz, weights.xyz);
  }
}

// Compute the gradients from the weights in both faces and their depths.
void findPartGradients(vec4 one, vec4 other, vec2 depths)
{
  initializeLine();
  findGradients(one);
  // assigned one by one, because Mesa 26 copies arrays incorrectly
  vec3 frontGradients[RELEVO_MATERIALS];
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    frontGradients[i] = walkGradients[i];
  }
  findGradients(other);
  setPartGradients(depths.x, depths.y, frontGradients);
}
#endif

void main()
{
  findCorners();
  vec4 first;
  vec4 last;
  vec2 inverse;
  if (!findWeights(first, last, inverse))
  {
    discard;
  }
  vec2 depths = vec2(dot(first, cornersDepth), dot(last, cornersDepth)) * inverse;
  Scalars one = getScalars(first, inverse.x);
  Scalars other = getScalars(last, inverse.y);
  bool isTurned = depths.y < depths.x;
  vec4 limits = texelFetch(rayLimits, ivec2(gl_FragCoord.xy), 0);
  walkBegin = limits.x;
  walkEnd = limits.y;
  walkDone = walkBegin;
  worldLength = limits.z;
  beginRay();
  beginPart(min(depths.x, depths.y), max(depths.x, depths.y), isTurned ? other : one,
    isTurned ? one : other);
#if RELEVO_LIT
  findPartGradients(first * inverse.x, last * inverse.y, depths);
#endif
#if RELEVO_STEEPNESS
  partSteepness = seenSteepness;
#endif
#if RELEVO_SEEN_PIECE
  beginSteps(seenPiece, partFront, partBack);
#else
  seekScalars(partFront);
#endif
  while (!isPartDone && collected.a < Opaque)
  {
    isPartDone = collect(partFront, partBack, partSpan, partFrom);
  }
#if RELEVO_MAPPED || RELEVO_ADDITIVE
  storeRay();
#else
  gl_FragData[0] = finishRay();
#endif
}
