//VTK::System::Dec
#define RELEVO_FUNCTION
//RELEVO::Defines
#if RELEVO_STEEPNESS
// The axes of the mesh are used instead of a ray's.
const vec3 rayU = vec3(1.0, 0.0, 0.0);
const vec3 rayV = vec3(0.0, 1.0, 0.0);
const vec3 rayDirection = vec3(0.0, 0.0, 1.0);
#endif

// The projected outline of each tetrahedron, from back to front. It is made of two triangles and
// slightly enlarged, because the fragment shader decides which rays hit.

uniform samplerBuffer meshPoints;
uniform samplerBuffer pointScalars;
uniform samplerBuffer cellScalars;
uniform samplerBuffer cornerScalars;
uniform usamplerBuffer cellCorners;
uniform isamplerBuffer cellOrder;
uniform vec2 zRange;

// The data of the four corners. If the near plane may clip tetrahedra, the first three are
// positions in the mesh, so that neighbouring cells get the same values.
#if RELEVO_SEEN_PIECE
flat out vec2 seenPiece; // index and end of the piece of the lowest scalar
#endif
flat out vec4 seenX;
flat out vec4 seenY;
flat out vec4 seenDepth;
flat out vec4 seenWeight;
#if RELEVO_CELL_SCALARS || RELEVO_COMPONENTS == 1
flat out vec4 seenScalars;
#else
flat out vec4 scalarsA;
flat out vec4 scalarsB;
flat out vec4 scalarsC;
flat out vec4 scalarsD;
#endif

flat out uvec4 seenIds; // of the corners' gradients

#if RELEVO_SEEN_PIECE || RELEVO_STEEPNESS
//RELEVO::Functions
#endif

#if RELEVO_STEEPNESS
flat out Scalars seenSteepness;
#endif

//RELEVO::Outline

vec4 points[4];
vec4 seen[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
// in pixels, if all are in front of the near plane
vec2 places[4] = vec2[4](vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));

float windingOf(int a, int b, int c)
{
  return windingOf(places[a], places[b], places[c]);
}

void setCorners(int cell, uvec4 ids)
{
#if RELEVO_CORNER_SCALARS
  seenIds = 4u * uint(cell) + uvec4(0u, 1u, 2u, 3u);
#else
  seenIds = ids;
#endif
  for (int i = 0; i < 4; ++i)
  {
#if RELEVO_CUT_BY_NEAR
    seenX[i] = points[i].x;
    seenY[i] = points[i].y;
    seenDepth[i] = points[i].z;
    seenWeight[i] = 1.0;
#else
    seenX[i] = places[i].x;
    seenY[i] = places[i].y;
    seenDepth[i] = seen[i].z;
    seenWeight[i] = 1.0 / seen[i].w;
#endif
  }
#if RELEVO_CELL_SCALARS
  seenScalars = texelFetch(cellScalars, cell);
#elif RELEVO_CORNER_SCALARS && RELEVO_COMPONENTS == 1
  seenScalars = texelFetch(cornerScalars, cell);
#elif RELEVO_CORNER_SCALARS
  scalarsA = texelFetch(cornerScalars, 4 * cell);
  scalarsB = texelFetch(cornerScalars, 4 * cell + 1);
  scalarsC = texelFetch(cornerScalars, 4 * cell + 2);
  scalarsD = texelFetch(cornerScalars, 4 * cell + 3);
#elif RELEVO_COMPONENTS == 1
  seenScalars = vec4(points[0].w, points[1].w, points[2].w, points[3].w);
#else
  scalarsA = texelFetch(pointScalars, int(ids.x));
  scalarsB = texelFetch(pointScalars, int(ids.y));
  scalarsC = texelFetch(pointScalars, int(ids.z));
  scalarsD = texelFetch(pointScalars, int(ids.w));
#endif
#if RELEVO_STEEPNESS
  vec3 origin = points[3].xyz;
#if RELEVO_COMPONENTS == 1
  vec3 scalars = seenScalars.xyz - vec3(seenScalars.w);
  setSteepness(points[0].xyz - origin, points[1].xyz - origin, points[2].xyz - origin, scalars.x,
    scalars.y, scalars.z);
#else
  setSteepness(points[0].xyz - origin, points[1].xyz - origin, points[2].xyz - origin,
    scalarsA - scalarsD, scalarsB - scalarsD, scalarsC - scalarsD);
#endif
  seenSteepness = partSteepness;
#endif
}

#if RELEVO_SEEN_PIECE || RELEVO_ISOSURFACE
// Return the lowest and highest scalar of a component.
vec2 getScalarRange(int component)
{
#if RELEVO_CELL_SCALARS
  return vec2(seenScalars[component]);
#else
#if RELEVO_COMPONENTS == 1
  vec4 all = seenScalars;
#else
  vec4 all = vec4(
    scalarsA[component], scalarsB[component], scalarsC[component], scalarsD[component]);
#endif
  return vec2(min(min(all.x, all.y), min(all.z, all.w)), max(max(all.x, all.y), max(all.z, all.w)));
#endif
}
#endif

#if RELEVO_SEEN_PIECE
// Find the piece, and return whether anything is visible in the range of the scalars.
bool findSeen()
{
  vec2 range = getScalarRange(0);
  findPiece(0, range.x);
  seenPiece = vec2(pieces[0].number, pieces[0].end);
  return range.y > pieces[0].end || pieces[0].first.w != 0.0 || pieces[0].change.w != 0.0;
}
#elif RELEVO_ISOSURFACE
uniform samplerBuffer isoValues; // as in relevoVolumeSurfaces.glsl
uniform int numberOfIsoValues;
uniform int isoComponent;
const float IsoMargin = 1e-5;

// Return whether the cell contains an isosurface.
bool findSeen()
{
  vec2 range = getScalarRange(isoComponent) + vec2(-IsoMargin, IsoMargin);
  bool isFound = false;
  for (int i = 0; i < numberOfIsoValues && !isFound; ++i)
  {
    float value = texelFetch(isoValues, 2 * i).x;
    isFound = value >= range.x && value <= range.y;
  }
  return isFound;
}
#else
bool findSeen()
{
  return true;
}
#endif

// In pixels; positions clipped by the near plane are less exact.
const float CutMargin = 1.0;

// Return a corner of the rectangle around the part in front of the near plane.
vec2 getSeenCorner(int corner)
{
  for (int i = 0; i < 4; ++i)
  {
    float a = seen[i].z - zRange.x * seen[i].w;
    if (a >= 0.0 && seen[i].w > 0.0)
    {
      surround(seen[i]);
    }
    for (int j = 0; j < i; ++j)
    {
      float b = seen[j].z - zRange.x * seen[j].w;
      if ((a < 0.0) != (b < 0.0))
      {
        surround(mix(seen[i], seen[j], a / (a - b)));
      }
    }
  }
  return getRectangleCorner(corner, CutMargin);
}

// Radon's partition of the corners is a point inside the triangle of the others, or two crossing
// lines.
vec2 getOutlineCorner(int corner)
{
  bool isUp0 = windingOf(1, 2, 3) > 0.0;
  bool isUp1 = windingOf(0, 2, 3) < 0.0;
  bool isUp2 = windingOf(0, 1, 3) > 0.0;
  bool isUp3 = windingOf(0, 1, 2) < 0.0;
  int count = int(isUp0) + int(isUp1) + int(isUp2) + int(isUp3);
  if (count == 0 || count == 4)
  {
    return getSeenCorner(corner); // all corners are collinear
  }
  int size = 4;
  ivec4 outline;
  if (count == 2)
  {
    int across = isUp1 == isUp0 ? 1 : isUp2 == isUp0 ? 2 : 3;
    ivec2 others = ivec2(across == 1 ? 2 : 1, across == 3 ? 2 : 3);
    // The quad is split along the shorter diagonal, where few pixels are processed twice.
    vec2 diagonal = places[across] - places[0];
    vec2 other = places[others.y] - places[others.x];
    outline = dot(diagonal, diagonal) <= dot(other, other)
      ? ivec4(0, others.x, across, others.y)
      : ivec4(others.x, across, others.y, 0);
  }
  else
  {
    bool isOdd = count == 1;
    int inner = isUp0 == isOdd ? 0 : isUp1 == isOdd ? 1 : isUp2 == isOdd ? 2 : 3;
    outline = ivec4(inner == 0 ? 1 : 0, inner <= 1 ? 2 : 1, inner == 3 ? 2 : 3, 0);
    size = 3;
  }
  int at = min(corner, size - 1);
  // Three corners of a quad can be collinear, if rays are parallel to a face.
  float winding = windingOf(outline[0], outline[1], outline[2]) +
    (size == 4 ? windingOf(outline[0], outline[2], outline[3]) : 0.0);
  return widen(places[outline[(at + size - 1) % size]], places[outline[at]],
    places[outline[(at + 1) % size]], winding);
}

// Return whether the centre of a pixel may be inside.
bool hasPixel()
{
  vec2 low = min(min(places[0], places[1]), min(places[2], places[3]));
  vec2 high = max(max(places[0], places[1]), max(places[2], places[3]));
  return all(lessThanEqual(
    ceil(low - vec2(0.5 + Margin)), floor(high - vec2(0.5 - Margin))));
}

void main()
{
  int cell = texelFetch(cellOrder, gl_VertexID / 4).r;
  uvec4 ids = texelFetch(cellCorners, cell);
  bool isInFront = true;
  for (int i = 0; i < 4; ++i)
  {
    points[i] = texelFetch(meshPoints, int(ids[i]));
    seen[i] = meshToSeen * vec4(points[i].xyz, 1.0);
    places[i] = seen[i].xy / seen[i].w;
    isInFront = isInFront && seen[i].w > 0.0 && seen[i].z >= zRange.x * seen[i].w;
  }
  setCorners(cell, ids);
  bool isSeen = findSeen() && (!isInFront || hasPixel());
  int corner = gl_VertexID % 4;
  vec2 place = !isSeen ? Unseen
    : isInFront        ? getOutlineCorner(corner)
                       : getSeenCorner(corner);
  gl_Position = placeOnScreen(place);
}
