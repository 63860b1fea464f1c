// Walks through an unsplit cell, from the face of entry to the next exit of the ray. Scalars along
// the way are those of the shape functions at both ends and at two points between. A cubic
// interpolates them, which is exact in a parallelepiped, and is drawn in as many linear segments as
// needed.

const float LargestMiss = 1.0 / 1024.0; // of the range of scalars
// The squared deviation of parameters from a straight line. If it is less, scalars are treated as a
// cubic.
const float MinimumBend = 4e-4;
const int MaximumHalvings = 3; // of the way through a cell whose scalars are not cubic
// In a tangled cell, parameters are ambiguous, and no piece of the way may be close to a cubic.
const int MaximumSpans = 16;
// Gradients are evaluated at the centres of segments, and lighting at their ends.
const float MinimumParts = RELEVO_STEEPNESS == 1 || RELEVO_LIT == 1 ? 4.0 : 1.0;
const float MaximumParts = 16.0;

int curvedSpans = 0; // of the way through the cell that have been processed
float curvedBegin = 0.0;
float curvedEnd = 0.0;

#if !RELEVO_CELL_SCALARS
// values at thirds of the way
Scalars cubic[4] = Scalars[4](Scalars(0.0), Scalars(0.0), Scalars(0.0), Scalars(0.0));

Scalars cubicAt(float x)
{
  float a = x - 1.0 / 3.0;
  float b = x - 2.0 / 3.0;
  float c = x - 1.0;
  return 4.5 * (x * a * b * cubic[3] - a * b * c * cubic[0]) +
    13.5 * (x * b * c * cubic[1] - x * a * c * cubic[2]);
}

bool isCubic(vec3 place0, vec3 place1, vec3 place2, vec3 place3)
{
  vec3 first = place0 - 2.0 * place1 + place2;
  vec3 last = place1 - 2.0 * place2 + place3;
  return max(dot(first, first), dot(last, last)) < MinimumBend;
}

// The error is tested at the midpoint, where it is about half of the maximum.
bool isCubicClose(Scalars middle)
{
  Scalars miss = abs(middle - cubicAt(0.5));
  float largest = 0.0;
  for (int i = 0; i < RELEVO_COMPONENTS; ++i)
  {
    largest = max(largest, componentOf(miss, i));
  }
  return largest < 0.25 * LargestMiss;
}

// Return the number of times that the rest of the way through the cell may be halved, plus 1.
int countHalvings()
{
  curvedSpans = isWithinCell ? curvedSpans + 1 : 0;
  return curvedSpans < MaximumSpans ? MaximumHalvings : 1;
}

float countParts()
{
  // The number follows from the second derivatives at both ends; they are linear in between.
  Scalars first = 9.0 * (2.0 * cubic[0] - 5.0 * cubic[1] + 4.0 * cubic[2] - cubic[3]);
  Scalars last = 9.0 * (2.0 * cubic[3] - 5.0 * cubic[2] + 4.0 * cubic[1] - cubic[0]);
  float bend = 0.0;
  for (int i = 0; i < RELEVO_COMPONENTS; ++i)
  {
    bend = max(bend, max(abs(componentOf(first, i)), abs(componentOf(last, i))));
  }
  return clamp(ceil(sqrt(bend / (8.0 * LargestMiss))), MinimumParts, MaximumParts);
}
#endif

#if RELEVO_STEEPNESS
Scalars curvedSteepness[3]; // at the centres of thirds of the way

void setCurvedSteepness(int third, Scalars steepness)
{
  curvedSteepness[third] = steepness;
}

Scalars steepnessAt(float x)
{
  float at = 3.0 * x - 0.5;
  Scalars steepness = at < 1.0 ? mix(curvedSteepness[0], curvedSteepness[1], at)
                               : mix(curvedSteepness[1], curvedSteepness[2], at - 1.0);
  return max(steepness, Scalars(0.0));
}
#endif

#if RELEVO_LIT
vec3 curvedGradients[4 * RELEVO_MATERIALS]; // at thirds of the way

void setCurvedGradient(int i, vec3 gradient)
{
  curvedGradients[i] = gradient;
}

vec3 curvedGradientAt(int material, float x)
{
  float third = min(floor(3.0 * x), 2.0);
  int i = 4 * material + int(third);
  return mix(curvedGradients[i], curvedGradients[i + 1], 3.0 * x - third);
}

vec3 fetchGradient(uint id, int material)
{
  int at = RELEVO_COMPONENTS * int(id) + RELEVO_SHADED_COMPONENT + material;
  return texelFetch(pointGradients, at).xyz;
}
#endif

// Return Newton's step to the point at a depth of the ray, for parameters with these derivatives.
vec3 newtonStep(float depth, vec3 place, vec3 du, vec3 dv, vec3 dw)
{
  vec3 miss = vec3(0.0, 0.0, depth) - place;
  vec3 across = cross(dv, dw);
  float volume = dot(du, across);
  vec3 move = vec3(dot(across, miss), dot(cross(dw, du), miss), dot(cross(du, dv), miss)) / volume;
  return abs(move.x) + abs(move.y) + abs(move.z) < 2.0 ? move : vec3(0.0);
}

// Return the rank of an exit; one behind the current depth is used only if there is no other.
float rankExit(float depth)
{
  return depth >= walkDepth - 1e-6 ? depth : 1e6 - depth;
}

#if RELEVO_FOLDED
// Return whether a point in a folded face, which may be the face of entry, is ahead.
bool isAhead(float depth)
{
  return depth > walkDepth + 1e-6;
}
#endif

void beginCurved(float end)
{
  curvedBegin = walkDepth;
  curvedEnd = end;
  curvedNext = 0.0;
  curvedParts = end > walkDepth ? 1.0 : 0.0;
#if RELEVO_CELL_SCALARS
  walkScalars = getCellScalars(walkCell);
  seekScalars(walkScalars);
#else
#if RELEVO_DISCONTINUOUS
  if (walkSide != SamePoints)
  {
    jumpTo(cubic[0]);
  }
#endif
  walkScalars = cubic[3];
  curvedParts *= countParts();
#endif
}

void nextCurvedPart()
{
  float first = curvedNext / curvedParts;
  float last = (curvedNext + 1.0) / curvedParts;
#if RELEVO_CELL_SCALARS
  Scalars front = walkScalars;
  Scalars back = front;
#else
  Scalars front = cubicAt(first);
  Scalars back = cubicAt(last);
#if RELEVO_INTEGRATED && !RELEVO_SURFACES
  // The line has the same mean as the cubic; a chord would be above or below it everywhere.
  Scalars lift = (cubicAt(0.5 * (first + last)) - 0.5 * (front + back)) * (2.0 / 3.0);
  front += lift;
  back += lift;
#endif
#endif
  float begin = mix(curvedBegin, curvedEnd, first);
  float end = mix(curvedBegin, curvedEnd, last);
  beginPart(begin, end, front, back);
#if RELEVO_STEEPNESS
  partSteepness = steepnessAt(0.5 * (first + last));
#endif
#if RELEVO_LIT
  vec3 frontGradients[RELEVO_MATERIALS];
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    frontGradients[i] = curvedGradientAt(i, first);
    walkGradients[i] = curvedGradientAt(i, last);
  }
  setPartGradients(begin, end, frontGradients);
#endif
  curvedNext += 1.0;
}

// The tetrahedron behind a face needs the face's corners.
void leaveToTetrahedron(Corner a, Corner b, Corner c)
{
  faceA = a;
  faceB = b;
  faceC = c;
  faceAreas = vec3(spannedArea(b.id, b.at.xy, c.id, c.at.xy),
    spannedArea(c.id, c.at.xy, a.id, a.at.xy), spannedArea(a.id, a.at.xy, b.id, b.at.xy));
#if !RELEVO_CELL_SCALARS
  scalarsA = getPointScalars(a.id, texelFetch(meshPoints, int(a.id)).w);
  scalarsB = getPointScalars(b.id, texelFetch(meshPoints, int(b.id)).w);
  scalarsC = getPointScalars(c.id, texelFetch(meshPoints, int(c.id)).w);
#endif
}

#if RELEVO_HANGING
// Move to the cell that the ray enters, one of those in a list; or to the nearest one, if the ray got
// here by rounding errors.
void moveToPart(uint list)
{
  int count = int(wordOfList(list, 0));
  int at = 1;
  int best = 1;
  float nearest = FarOutside;
  for (int part = 0; part < count && nearest >= 0.0; ++part)
  {
    int size = int(wordOfList(list, at + 1));
    int passes = 0;
    vec2 sum = vec2(0.0);
    Corner from = getCorner(wordOfList(list, at + 1 + size));
    for (int i = 0; i < size; ++i)
    {
      Corner to = getCorner(wordOfList(list, at + 2 + i));
      passes += passesOf(from, to);
      sum += to.at.xy;
      from = to;
    }
    float distance = passes > 0 ? -1.0 : length(sum) / float(size);
    best = distance < nearest ? at : best;
    nearest = min(distance, nearest);
    at += 2 + size;
  }
  moveTo(wordOfList(list, best));
  if (!isCurvedCell(walkCell))
  {
    leaveToTetrahedron(getCorner(wordOfList(list, best + 2)),
      getCorner(wordOfList(list, best + 3)), getCorner(wordOfList(list, best + 4)));
  }
}
#endif

// Move to the cell behind an exit. If there is none, because the ray touches a fold that only one
// of the cells detects, go back to the previous cell. Return whether the next cell is a tetrahedron
// that needs the corners of the face.
bool leaveTo(int exit)
{
#if RELEVO_FOLDED
  uint before = walkBefore;
  walkBefore = exit < 0 ? Nothing : walkCell;
#endif
  uint neighbor = exit < 0 ? Nothing : wordOfCell(walkCell, FirstBehind + exit);
#if RELEVO_HANGING
  bool areSeveral = neighbor != Nothing && neighbor % 8u == SeveralCells;
  for (int i = areSeveral ? 0 : 1; i < min(1, maximumSteps); ++i)
  {
    moveToPart(neighbor / 8u);
  }
  if (areSeveral)
  {
    return false;
  }
#endif
  moveTo(neighbor);
#if RELEVO_FOLDED
  walkCell = exit < 0 ? before : walkCell;
#endif
  return walkCell != Nothing && !isCurvedCell(walkCell);
}

vec3 hexPlaces[8]; // in the ray's coordinates

void setHexPlace(int corner, vec3 place)
{
  hexPlaces[corner] = place;
}

#define trilinear(c, p) \
  mix(mix(mix(c[0], c[1], (p).x), mix(c[3], c[2], (p).x), (p).y), \
    mix(mix(c[4], c[5], (p).x), mix(c[7], c[6], (p).x), (p).y), (p).z)

// Positions as polynomials with terms 1, x, y, z, xy, yz, zx and xyz.
vec3 hexTerms[8];

void findHexTerms()
{
  hexTerms[0] = hexPlaces[0];
  hexTerms[1] = hexPlaces[1] - hexPlaces[0];
  hexTerms[2] = hexPlaces[3] - hexPlaces[0];
  hexTerms[3] = hexPlaces[4] - hexPlaces[0];
  hexTerms[4] = hexPlaces[2] - hexPlaces[3] - hexTerms[1];
  hexTerms[5] = hexPlaces[7] - hexPlaces[4] - hexTerms[2];
  hexTerms[6] = hexPlaces[5] - hexPlaces[4] - hexTerms[1];
  hexTerms[7] = hexPlaces[6] - hexPlaces[7] - hexTerms[1] - hexTerms[4] - hexTerms[6];
}

vec3 seekInHexahedron(float depth, vec3 p)
{
  vec3 du = hexTerms[1] + p.y * hexTerms[4] + p.z * (hexTerms[6] + p.y * hexTerms[7]);
  vec3 dv = hexTerms[2] + p.x * hexTerms[4] + p.z * (hexTerms[5] + p.x * hexTerms[7]);
  vec3 dw = hexTerms[3] + p.y * hexTerms[5] + p.x * (hexTerms[6] + p.y * hexTerms[7]);
  vec3 place =
    hexTerms[0] + p.x * du + p.y * (hexTerms[2] + p.z * hexTerms[5]) + p.z * hexTerms[3];
  return newtonStep(depth, place, du, dv, dw);
}

// One step usually suffices. The limit is not a constant, because drivers would unroll the loop and
// always execute all steps.
vec3 parametersInHexahedron(float depth, vec3 p)
{
  for (int i = 0; i < min(3, maximumSteps); ++i)
  {
    vec3 move = seekInHexahedron(depth, p);
    p += move;
    if (dot(move, move) < 1e-4)
    {
      break; // the remaining error is 1e-4 of it
    }
  }
  return clamp(p, vec3(0.0), vec3(1.0));
}

// Faces 0 and 1 are at the first parameter 0 and 1, and so on.
void getHexFace(int face, out vec3 p0, out vec3 p1, out vec3 p2, out vec3 p3)
{
  bool high = face % 2 == 1;
  p0 = high ? hexPlaces[1] : hexPlaces[0];
  p1 = high ? hexPlaces[2] : hexPlaces[3];
  p2 = high ? hexPlaces[6] : hexPlaces[7];
  p3 = high ? hexPlaces[5] : hexPlaces[4];
  if (face >= 4)
  {
    p0 = high ? hexPlaces[4] : hexPlaces[0];
    p1 = high ? hexPlaces[5] : hexPlaces[1];
    p2 = high ? hexPlaces[6] : hexPlaces[2];
    p3 = high ? hexPlaces[7] : hexPlaces[3];
  }
  else if (face >= 2)
  {
    p0 = high ? hexPlaces[3] : hexPlaces[0];
    p1 = high ? hexPlaces[2] : hexPlaces[1];
    p2 = high ? hexPlaces[6] : hexPlaces[5];
    p3 = high ? hexPlaces[7] : hexPlaces[4];
  }
}

vec3 parametersOnHexFace(int face, vec2 at)
{
  float side = face % 2 == 1 ? 1.0 : 0.0;
  return face < 2 ? vec3(side, at) : face < 4 ? vec3(at.x, side, at.y) : vec3(at, side);
}

#if RELEVO_PYRAMIDS
const float ThickestSpan = 1.5; // ratio of the distances from the apex at both ends
const float NearTop = 1.0 / 128.0;

// The line from the apex through the point intersects the base. The third parameter is 1 at the
// apex.
vec3 parametersInPyramid(float depth)
{
  vec3 from = vec3(0.0, 0.0, depth) - hexPlaces[4];
  vec3 size = abs(from);
  vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(1.0, 0.0, 0.0)
    : size.y <= size.z                             ? vec3(0.0, 1.0, 0.0)
                                                   : vec3(0.0, 0.0, 1.0);
  vec3 u = cross(from, axis);
  u /= max(length(u), 1e-30);
  vec3 v = cross(from, u);
  v /= max(length(v), 1e-30);
  vec2 base[4];
  for (int i = 0; i < 4; ++i)
  {
    vec3 edge = hexPlaces[i] - hexPlaces[4];
    base[i] = vec2(dot(edge, u), dot(edge, v));
  }
  float outside;
  vec2 at = crossBilinear(base[0], base[1], base[2], base[3], outside);
  vec3 end = mix(mix(hexPlaces[0], hexPlaces[1], at.x), mix(hexPlaces[3], hexPlaces[2], at.x), at.y) -
    hexPlaces[4];
  return vec3(at, clamp(1.0 - dot(from, end) / dot(end, end), 0.0, 1.0));
}

// Scalars depend on the inverse distance from the apex. A cubic is not sufficient if that varies
// much.
float findPyramidSpan(float entered, float left, float end)
{
  float first = 1.0 - entered;
  float last = 1.0 - left;
  float next = last < first ? first / ThickestSpan : max(first, NearTop) * ThickestSpan;
  bool isWhole = max(first, last) < NearTop ||
    (last < first ? next < max(last, NearTop) : next > last);
  return isWhole ? end : mix(walkDepth, end, (next - first) / (last - first));
}
#endif

const float MinimumAside = 0.501; // parameter distance from the centre of a face

// Intersect the ray with a face: return the depth, and set the parameters there. If a face is seen
// edge-on, the ray is in both cells: it continues in the next cell at once, and the parameters are
// not used.
float crossHexFace(int face, out vec3 parameters, out bool isAside)
{
  vec3 p0;
  vec3 p1;
  vec3 p2;
  vec3 p3;
  getHexFace(face, p0, p1, p2, p3);
  float outside;
  vec2 at = crossBilinear(p0.xy, p1.xy, p2.xy, p3.xy, outside);
  parameters = parametersOnHexFace(face, at);
  isAside = outside > MinimumAside;
  return isAside ? walkDepth : mix(mix(p0.z, p1.z, at.x), mix(p3.z, p2.z, at.x), at.y);
}

// Return two bit masks: the faces through which the ray leaves, and those through which it enters.
// The list of the cell's edges has this address; 0 for none.
ivec2 windHexahedron(uint ids[8], uint list)
{
#define passes(a, b) passesOf(Corner(ids[a], hexPlaces[a]), Corner(ids[b], hexPlaces[b]))
  ivec4 below = ivec4(passes(0, 1), passes(1, 2), passes(2, 3), passes(3, 0));
  ivec4 above = ivec4(passes(4, 5), passes(5, 6), passes(6, 7), passes(7, 4));
  ivec4 up = ivec4(passes(0, 4), passes(1, 5), passes(2, 6), passes(3, 7));
#if RELEVO_HANGING
  // Loops for what is rare, because software renderers execute both sides of a branch. Corners are
  // fetched, because arrays with indices that vary are slow.
  for (int i = list == 0u ? 4 : 0; i < 4; ++i)
  {
    int next = (i + 1) % 4;
    Corner low = getCorner(wordOfCell(walkCell, i));
    Corner lowNext = getCorner(wordOfCell(walkCell, next));
    Corner high = getCorner(wordOfCell(walkCell, i + 4));
    Corner highNext = getCorner(wordOfCell(walkCell, next + 4));
    ivec4 one = ivec4(equal(ivec4(i), ivec4(0, 1, 2, 3)));
    below += one * (passesOfEdge(list, i, low, lowNext) - passesOf(low, lowNext));
    above += one * (passesOfEdge(list, 4 + i, high, highNext) - passesOf(high, highNext));
    up += one * (passesOfEdge(list, 8 + i, low, high) - passesOf(low, high));
  }
#endif
  ivec4 sides = ivec4(up.x - above.w - up.w + below.w, below.y + up.z - above.y - up.y,
    below.x + up.y - above.x - up.x, up.w - above.z - up.z + below.z);
  ivec2 ends = ivec2(-below.x - below.y - below.z - below.w, above.x + above.y + above.z + above.w);
  const ivec4 bits = ivec4(1, 2, 4, 8);
  ivec4 left = bits * ivec4(greaterThan(sides, ivec4(0)));
  ivec4 entered = bits * ivec4(lessThan(sides, ivec4(0)));
  return ivec2(left.x + left.y + left.z + left.w + (ends.x > 0 ? 16 : 0) + (ends.y > 0 ? 32 : 0),
    entered.x + entered.y + entered.z + entered.w + (ends.x < 0 ? 16 : 0) + (ends.y < 0 ? 32 : 0));
}

// Return the index of the highest bit that is set; -1 if there is none.
int highestBit(int bits)
{
  return bits >= 32 ? 5 : bits >= 16 ? 4 : bits >= 8 ? 3 : bits >= 4 ? 2 : bits >= 2 ? 1 : bits - 1;
}

#if RELEVO_FOLDED
// Return a bit mask of the faces that may wind around the ray, such as folded ones.
int findAround()
{
  int around = 0;
  for (int face = 0; face < 6; ++face)
  {
    vec3 p0;
    vec3 p1;
    vec3 p2;
    vec3 p3;
    getHexFace(face, p0, p1, p2, p3);
    around += isAround(min(min(p0.xy, p1.xy), min(p2.xy, p3.xy)),
      max(max(p0.xy, p1.xy), max(p2.xy, p3.xy))) ? 1 << face : 0;
  }
  return around;
}
#endif

#if RELEVO_HANGING
const float Nudge = 0.01; // of the distance from the centre of the cell

// Find the exit of a ray next to the cell, which got there by rounding errors from a tetrahedron.
// The ray is moved towards the centre of the cell. Return the exit, its depth and the parameters.
int leaveFromNearby(uint ids[8], inout float end, inout vec3 leftAt)
{
  vec2 center = vec2(0.0);
  for (int i = 0; i < 8; ++i)
  {
    center += hexPlaces[i].xy / 8.0;
  }
  for (int i = 0; i < 8; ++i)
  {
    hexPlaces[i].xy -= Nudge * center;
  }
  int faces = windHexahedron(ids, 0u).x;
  int exit = -1;
  while (faces > 0)
  {
    int face = highestBit(faces);
    faces -= 1 << face;
    vec3 parameters;
    bool isAside;
    float depth = crossHexFace(face, parameters, isAside);
    if (exit < 0 || depth > end)
    {
      exit = face;
      end = depth;
      leftAt = parameters;
    }
  }
  return exit;
}
#endif

void crossHexahedron()
{
  int at = 4 * (int(walkCell) - numberOfTetrahedra);
  uvec4 low = texelFetch(curvedCells, at);
  uvec4 high = texelFetch(curvedCells, at + 1);
  uint ids[8] = uint[8](low.x, low.y, low.z, low.w, high.x, high.y, high.z, high.w);
#if !RELEVO_CELL_SCALARS
  Scalars corners[8];
#endif
  for (int i = 0; i < 8; ++i)
  {
    vec4 point = texelFetch(meshPoints, int(ids[i]));
    setHexPlace(i, seenAlongRay(point.xyz));
#if !RELEVO_CELL_SCALARS
    corners[i] = getPointScalars(ids[i], point.w);
#endif
  }
#if RELEVO_HANGING
  ivec2 faces = windHexahedron(ids, wordOfCell(walkCell, 8));
#else
  ivec2 faces = windHexahedron(ids, 0u);
#endif
#if RELEVO_FOLDED
  int allFaces = faces.x + faces.y;
#endif
  int exit = -1;
  float end = FarOutside;
  float begin = FarOutside;
  vec3 leftAt = vec3(0.5);
  vec3 enteredAt = vec3(0.5);
  bool isEnteredAside = false;
  // Usually there is one of each. A cell that is not convex may have several exits.
  while (faces.x + faces.y > 0)
  {
    bool isExit = faces.x > 0;
    int face = highestBit(isExit ? faces.x : faces.y);
    faces -= isExit ? ivec2(1 << face, 0) : ivec2(0, 1 << face);
    vec3 parameters;
    bool isAside;
    float depth = crossHexFace(face, parameters, isAside);
    if (isExit && (exit < 0 || rankExit(depth) < rankExit(end)))
    {
      exit = face;
      end = depth;
      leftAt = parameters;
    }
    if (!isExit && abs(depth - walkDepth) < abs(begin - walkDepth))
    {
      begin = depth;
      enteredAt = parameters;
      isEnteredAside = isAside;
    }
  }
#if RELEVO_FOLDED
  int folded = findAround() & ~allFaces;
  while (folded > 0)
  {
    int face = highestBit(folded);
    folded -= 1 << face;
    vec3 p0;
    vec3 p1;
    vec3 p2;
    vec3 p3;
    getHexFace(face, p0, p1, p2, p3);
    foldBilinear(p0.xy, p1.xy, p2.xy, p3.xy);
    // The corners of these faces are counterclockwise seen from outside.
    float way = face == 1 || face == 2 || face == 5 ? 1.0 : -1.0;
    for (int i = 0; i < foldCount; ++i)
    {
      vec2 at = foldPlaces[i].xy;
      float depth = mix(mix(p0.z, p1.z, at.x), mix(p3.z, p2.z, at.x), at.y);
      if (way * foldTurns[i] > 0.0)
      {
        if (isAhead(depth) && (exit < 0 || depth < rankExit(end)))
        {
          exit = face;
          end = depth;
          leftAt = parametersOnHexFace(face, at);
        }
      }
      else if (abs(depth - walkDepth) < abs(begin - walkDepth))
      {
        begin = depth;
        enteredAt = parametersOnHexFace(face, at);
        isEnteredAside = false;
      }
    }
  }
#endif
#if RELEVO_HANGING
  for (int i = exit < 0 ? 0 : 1; i < min(1, maximumSteps); ++i)
  {
    exit = leaveFromNearby(ids, end, leftAt);
  }
#endif
  end = exit < 0 ? walkDepth : max(end, walkDepth);
  float to = end;
#if !RELEVO_CELL_SCALARS
  findHexTerms();
  if (isEnteredAside || isWithinCell)
  {
    enteredAt = parametersInHexahedron(walkDepth, vec3(0.5));
  }
#if RELEVO_PYRAMIDS
#define seekInside(depth, guess) \
  (isPyramid ? parametersInPyramid(depth) : parametersInHexahedron(depth, guess))
  bool isPyramid = ids[4] == ids[5] && ids[5] == ids[6];
  if (isPyramid)
  {
    enteredAt = parametersInPyramid(walkDepth);
    to = findPyramidSpan(enteredAt.z, parametersInPyramid(end).z, end);
    leftAt = parametersInPyramid(to);
  }
#else
#define seekInside(depth, guess) parametersInHexahedron(depth, guess)
#endif
  cubic[0] = trilinear(corners, enteredAt);
  vec3 one;
  vec3 two;
  int halvings = countHalvings();
  // In a cell with flat faces, they are a cubic or nearly so.
  for (int i = 0; i < (RELEVO_FOLDED == 1 ? min(halvings, maximumSteps) : 1); ++i)
  {
    one = seekInside(mix(walkDepth, to, 1.0 / 3.0), mix(enteredAt, leftAt, 1.0 / 3.0));
    cubic[1] = trilinear(corners, one);
    two = seekInside(mix(walkDepth, to, 2.0 / 3.0), mix(enteredAt, leftAt, 2.0 / 3.0));
    cubic[2] = trilinear(corners, two);
    cubic[3] = trilinear(corners, leftAt);
#if RELEVO_FOLDED
    if (isCubic(enteredAt, one, two, leftAt) || i == halvings - 1)
    {
      break;
    }
    float halfway = mix(walkDepth, to, 0.5);
    vec3 middle = seekInside(halfway, mix(one, two, 0.5));
    if (isCubicClose(trilinear(corners, middle)))
    {
      break;
    }
    to = halfway;
    leftAt = middle;
#endif
  }
#if RELEVO_STEEPNESS || RELEVO_LIT
  vec3 places[4] = vec3[4](enteredAt, one, two, leftAt);
#endif
#if RELEVO_STEEPNESS
  for (int i = 0; i < 3; ++i)
  {
    vec3 middle = mix(places[i], places[i + 1], 0.5);
    vec3 u = vec3(1.0, middle.yz);
    vec3 v = vec3(middle.x, 1.0, middle.z);
    vec3 w = vec3(middle.xy, 1.0);
    setSteepness(trilinear(hexPlaces, u) - trilinear(hexPlaces, vec3(0.0, u.yz)),
      trilinear(hexPlaces, v) - trilinear(hexPlaces, vec3(v.x, 0.0, v.z)),
      trilinear(hexPlaces, w) - trilinear(hexPlaces, vec3(w.xy, 0.0)),
      trilinear(corners, u) - trilinear(corners, vec3(0.0, u.yz)),
      trilinear(corners, v) - trilinear(corners, vec3(v.x, 0.0, v.z)),
      trilinear(corners, w) - trilinear(corners, vec3(w.xy, 0.0)));
    setCurvedSteepness(i, partSteepness);
  }
#endif
#endif
#if RELEVO_LIT
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    vec3 gradients[8];
    for (int j = 0; j < 8; ++j)
    {
      gradients[j] = fetchGradient(ids[j], i);
    }
    for (int j = 0; j < 4; ++j)
    {
      setCurvedGradient(4 * i + j, trilinear(gradients, places[j]));
    }
  }
#endif
  beginCurved(to);
  walkDepth = to;
#if !RELEVO_CELL_SCALARS
  isWithinCell = to < end;
  if (isWithinCell)
  {
    return; // the rest of the cell follows
  }
#endif
  if (leaveTo(exit))
  {
    // Two of the four corners may coincide.
    ivec4 face = ivec4(cornerOfFace(false, exit, 0), cornerOfFace(false, exit, 1),
      cornerOfFace(false, exit, 2), cornerOfFace(false, exit, 3));
    bool isFirstTwice = ids[face.x] == ids[face.y] || ids[face.x] == ids[face.w];
    int b = isFirstTwice && ids[face.x] == ids[face.y] ? face.z : face.y;
    int c = isFirstTwice ? (ids[face.x] == ids[face.y] ? face.w : face.z)
                         : (ids[face.y] == ids[face.z] ? face.w : face.z);
    c = !isFirstTwice && ids[face.z] == ids[face.w] ? face.z : c;
    leaveToTetrahedron(Corner(ids[face.x], hexPlaces[face.x]), Corner(ids[b], hexPlaces[b]),
      Corner(ids[c], hexPlaces[c]));
  }
}

#if RELEVO_QUADRATIC
vec3 quadraticPlaces[10]; // in the ray's coordinates

// b are barycentric coordinates of corners 0 to 3; points 4 to 9 are on the edges 01, 12, 20, 03,
// 13 and 23.
#define quadratic(c, b) \
  ((b).x * (2.0 * (b).x - 1.0) * c[0] + (b).y * (2.0 * (b).y - 1.0) * c[1] + \
    (b).z * (2.0 * (b).z - 1.0) * c[2] + (b).w * (2.0 * (b).w - 1.0) * c[3] + \
    4.0 * ((b).x * (b).y * c[4] + (b).y * (b).z * c[5] + (b).z * (b).x * c[6] + \
      (b).x * (b).w * c[7] + (b).y * (b).w * c[8] + (b).z * (b).w * c[9]))

vec4 barycentric(vec3 p)
{
  return vec4(1.0 - p.x - p.y - p.z, p);
}

vec3 placeInQuadratic(vec3 p)
{
  return quadratic(quadraticPlaces, barycentric(p));
}

// Differences are exact derivatives, because positions are quadratic in each parameter.
vec3 parametersInQuadratic(float depth, vec3 p)
{
  for (int i = 0; i < 3; ++i)
  {
    vec2 h = vec2(0.5, 0.0);
    p += newtonStep(depth, placeInQuadratic(p),
      placeInQuadratic(p + h.xyy) - placeInQuadratic(p - h.xyy),
      placeInQuadratic(p + h.yxy) - placeInQuadratic(p - h.yxy),
      placeInQuadratic(p + h.yyx) - placeInQuadratic(p - h.yyx));
  }
  return clamp(p, vec3(0.0), vec3(1.0));
}

#if RELEVO_FOLDED
// Return whether the walk can continue in the cell behind a folded face; a tetrahedron has no
// folds.
bool leadsOn(int face)
{
  uint next = cellOfNeighbor(wordOfCell(walkCell, FirstBehind + face));
  return next == Nothing || isCurvedCell(next);
}
#endif

void loadQuadraticFace(uint ids[10], int face, out Corner border[6])
{
  for (int i = 0; i < 6; ++i)
  {
    int corner = cornerOfFace(true, face, i);
    border[i] = Corner(ids[corner], quadraticPlaces[corner]);
  }
}

void crossQuadraticCell()
{
  uint ids[10];
#if !RELEVO_CELL_SCALARS
  Scalars corners[10];
#endif
  for (int i = 0; i < 10; ++i)
  {
    ids[i] = wordOfCell(walkCell, i);
    vec4 point = texelFetch(meshPoints, int(ids[i]));
    quadraticPlaces[i] = seenAlongRay(point.xyz);
#if !RELEVO_CELL_SCALARS
    corners[i] = getPointScalars(ids[i], point.w);
#endif
  }
  int exit = -1;
  float end = FarOutside;
  float begin = FarOutside;
  vec3 leftAt = vec3(0.25);
  vec3 enteredAt = vec3(0.25);
  Corner border[6];
  for (int face = 0; face < 4; ++face)
  {
    loadQuadraticFace(ids, face, border);
    int winding = windingOf(border, 6);
#if RELEVO_FOLDED
    foldQuadratic(border, winding);
    for (int i = 0; i < foldCount; ++i)
    {
      float at = depthOnFace(true, border, foldPlaces[i]);
      bool isExit = foldTurns[i] > 0.0;
      if (isExit && isAhead(at) && leadsOn(face) && (exit < 0 || at < rankExit(end)))
      {
        exit = face;
        end = at;
        leftAt = parametersOnFace(true, face, foldPlaces[i]);
      }
      if (!isExit && abs(at - walkDepth) < abs(begin - walkDepth))
      {
        begin = at;
        enteredAt = parametersOnFace(true, face, foldPlaces[i]);
      }
    }
    if (foldCount > 0)
    {
      continue;
    }
#endif
    if (winding == 0)
    {
      continue;
    }
    vec3 parameters;
    float depth = crossFace(true, face, border, parameters);
    if (winding > 0 && (exit < 0 || rankExit(depth) < rankExit(end)))
    {
      exit = face;
      end = depth;
      leftAt = parameters;
    }
    if (winding < 0 && abs(depth - walkDepth) < abs(begin - walkDepth))
    {
      begin = depth;
      enteredAt = parameters;
    }
  }
  end = exit < 0 ? walkDepth : max(end, walkDepth);
  float to = end;
#if !RELEVO_CELL_SCALARS
  if (isWithinCell)
  {
    enteredAt = parametersInQuadratic(walkDepth, vec3(0.25));
  }
  cubic[0] = quadratic(corners, barycentric(enteredAt));
  vec3 one;
  vec3 two;
  int halvings = countHalvings();
  for (int i = 0; i < min(halvings, maximumSteps); ++i)
  {
    one = parametersInQuadratic(
      mix(walkDepth, to, 1.0 / 3.0), mix(enteredAt, leftAt, 1.0 / 3.0));
    cubic[1] = quadratic(corners, barycentric(one));
    two = parametersInQuadratic(
      mix(walkDepth, to, 2.0 / 3.0), mix(enteredAt, leftAt, 2.0 / 3.0));
    cubic[2] = quadratic(corners, barycentric(two));
    cubic[3] = quadratic(corners, barycentric(leftAt));
    if (isCubic(enteredAt, one, two, leftAt) || i == halvings - 1)
    {
      break;
    }
    float halfway = mix(walkDepth, to, 0.5);
    vec3 middle = parametersInQuadratic(halfway, mix(one, two, 0.5));
    if (isCubicClose(quadratic(corners, barycentric(middle))))
    {
      break;
    }
    to = halfway;
    leftAt = middle;
  }
#if RELEVO_STEEPNESS || RELEVO_LIT
  vec3 places[4] = vec3[4](enteredAt, one, two, leftAt);
#endif
#if RELEVO_STEEPNESS
  vec2 h = vec2(0.5, 0.0);
#define change(c, step) \
  (quadratic(c, barycentric(middle + (step))) - quadratic(c, barycentric(middle - (step))))
  for (int i = 0; i < 3; ++i)
  {
    vec3 middle = mix(places[i], places[i + 1], 0.5);
    setSteepness(change(quadraticPlaces, h.xyy), change(quadraticPlaces, h.yxy),
      change(quadraticPlaces, h.yyx), change(corners, h.xyy), change(corners, h.yxy),
      change(corners, h.yyx));
    setCurvedSteepness(i, partSteepness);
  }
#endif
#endif
#if RELEVO_LIT
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    vec3 gradients[10];
    for (int j = 0; j < 10; ++j)
    {
      gradients[j] = fetchGradient(ids[j], i);
    }
    for (int j = 0; j < 4; ++j)
    {
      setCurvedGradient(4 * i + j, quadratic(gradients, barycentric(places[j])));
    }
  }
#endif
  beginCurved(to);
  walkDepth = to;
#if !RELEVO_CELL_SCALARS
  isWithinCell = to < end;
  if (isWithinCell)
  {
    return;
  }
#endif
  if (leaveTo(exit))
  {
    loadQuadraticFace(ids, exit, border);
    leaveToTetrahedron(border[0], border[2], border[4]);
  }
}
#endif

void crossCurved()
{
#if RELEVO_QUADRATIC
  if (isQuadraticCell(walkCell))
  {
    crossQuadraticCell();
    return;
  }
#endif
  crossHexahedron();
}
