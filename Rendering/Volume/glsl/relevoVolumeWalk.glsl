// Walks from tetrahedron to tetrahedron. The ray leaves through the face whose projected edges wind
// around it. Both cells of a face get the same result, so that no ray gets lost between them or
// turns back, for all shapes of cells.
//
// M. Weiler, M. Kraus, M. Merz, T. Ertl, "Hardware-Based Ray Casting for Tetrahedral Meshes", IEEE
// Visualization 2003, with one point and three areas per step instead of four planes.

uniform usamplerBuffer pointSums;
uniform usamplerBuffer neighbors;
uniform samplerBuffer pointScalars;
uniform samplerBuffer cellScalars;
uniform int maximumSteps;

const uint Nothing = 0xffffffffu;
#if RELEVO_DISCONTINUOUS
const uint SamePoints = 4u; // instead of the index of a face, if both cells have the same scalars
#endif

// The state of the walk: the next cell, and the face through which it is entered. The initial values
// keep compilers from warnings about functions that read a variable before another one sets it.
uint walkCell = Nothing;
float walkDepth = 0.0;
Corner faceA = NoCorner;
Corner faceB = NoCorner;
Corner faceC = NoCorner;
vec3 faceAreas = vec3(0.0); // spanned by the edges opposite to the corners

Scalars walkScalars = Scalars(0.0); // scalars at the position of the walk

#if RELEVO_CELL_SCALARS
Scalars getCellScalars(uint cell)
{
#if RELEVO_COMPONENTS == 1
  return texelFetch(cellScalars, int(cell)).r;
#else
  return texelFetch(cellScalars, int(cell));
#endif
}
#else
Scalars scalarsA = Scalars(0.0);
Scalars scalarsB = Scalars(0.0);
Scalars scalarsC = Scalars(0.0);

Scalars getPointScalars(uint id, float first)
{
#if RELEVO_COMPONENTS == 1
  return first;
#else
  return texelFetch(pointScalars, int(id));
#endif
}

Scalars interpolateScalars(vec3 weights)
{
#if RELEVO_SAME_SUMS
  Scalars scalars;
  for (int i = 0; i < RELEVO_WIDTH; ++i)
  {
    RELEVO_PRECISE vec3 parts = weights *
      vec3(componentOf(scalarsA, i), componentOf(scalarsB, i), componentOf(scalarsC, i));
    componentOf(scalars, i) = sumInOrder(parts);
  }
  return scalars;
#else
  return weights.x * scalarsA + weights.y * scalarsB + weights.z * scalarsC;
#endif
}
#endif

#if RELEVO_CORNER_SCALARS
uniform samplerBuffer cornerScalars; // of tetrahedra, in the order of their points
vec3 walkWeights = vec3(0.0); // of the face's corners at the position of the walk

// Return the scalars of a tetrahedron's corner, given `all` of a single component.
Scalars getCornerScalars(vec4 all, int corner)
{
#if RELEVO_COMPONENTS == 1
  return all[corner];
#else
  return texelFetch(cornerScalars, 4 * int(walkCell) + corner);
#endif
}
#endif

#if RELEVO_DISCONTINUOUS
uint walkSide = SamePoints; // the face through which the cell is entered, or SamePoints
#endif

// Return the cell of an entry in the list of neighbours.
uint cellOfNeighbor(uint neighbor)
{
#if RELEVO_DISCONTINUOUS
  return neighbor == Nothing ? Nothing : neighbor / 8u;
#else
  return neighbor;
#endif
}

#if RELEVO_ACTIVE
uniform usamplerBuffer activeCells; // a bit for each cell

// Return the cell, or nothing if it is not active.
uint activeCell(uint cell)
{
  uint bits = cell == Nothing ? 0u : texelFetch(activeCells, int(cell / 32u)).r;
  return ((bits >> (cell % 32u)) & 1u) != 0u ? cell : Nothing;
}
#endif

void moveTo(uint neighbor)
{
  walkCell = cellOfNeighbor(neighbor);
#if RELEVO_ACTIVE
  walkCell = activeCell(walkCell);
#endif
#if RELEVO_DISCONTINUOUS
  walkSide = neighbor == Nothing ? SamePoints : neighbor % 8u;
#endif
}

#if RELEVO_DISCONTINUOUS || RELEVO_CORNER_SCALARS
// Continue with other scalars. The previous cell must have been processed. The pieces of functions
// are not searched, because software renderers would search in each step: see nextPiece().
void jumpTo(Scalars scalars)
{
#if RELEVO_DISCONTINUOUS
  walkSide = SamePoints;
#endif
  walkScalars = scalars;
#if RELEVO_SURFACES
  isIsoNew = true;
#endif
}
#endif

#if RELEVO_CURVED
float curvedParts = 0.0; // number of segments of a cell
float curvedNext = 0.0;  // index of the next segment
bool isWithinCell = false; // the last step ended before the cell does
#if RELEVO_FOLDED
uint walkBefore = Nothing; // the previous cell
#endif
#endif

#if RELEVO_DISCONTINUOUS
// Use the scalars of the tetrahedron at the face through which it is entered. The face's corners
// have the same order as in the previous cell.
void takeScalars()
{
  uvec4 all = texelFetch(tetrahedronCorners, int(walkCell));
  uvec3 own = walkSide == 0u ? all.yzw
    : walkSide == 1u         ? all.xzw
    : walkSide == 2u         ? all.xyw
                             : all.xyz;
  uvec3 ids = uvec3(faceA.id, faceB.id, faceC.id);
  faceA.id = own[int(ids.y < ids.x) + int(ids.z < ids.x)];
  faceB.id = own[int(ids.x < ids.y) + int(ids.z < ids.y)];
  faceC.id = own[int(ids.x < ids.z) + int(ids.y < ids.z)];
#if RELEVO_CELL_SCALARS
  walkSide = SamePoints;
#else
  scalarsA = getPointScalars(faceA.id, texelFetch(meshPoints, int(faceA.id)).w);
  scalarsB = getPointScalars(faceB.id, texelFetch(meshPoints, int(faceB.id)).w);
  scalarsC = getPointScalars(faceC.id, texelFetch(meshPoints, int(faceC.id)).w);
  vec3 weights;
  bool isSeen = getWeights(faceAreas, weights);
  weights = isSeen ? weights : vec3(1.0, 0.0, 0.0);
  jumpTo(interpolateScalars(weights));
#if RELEVO_LIT
  walkToGradients(uvec3(faceA.id, faceB.id, faceC.id), weights);
#endif
#endif
}
#endif

void enterMesh(Entry entry)
{
  walkCell = entry.cell;
#if RELEVO_DISCONTINUOUS
  walkSide = SamePoints;
#endif
  walkDepth = entry.depth;
  faceA = entry.a;
  faceB = entry.b;
  faceC = entry.c;
  faceAreas = entry.areas;
#if RELEVO_SURFACES
  isIsoNew = true;
#endif
#if RELEVO_CURVED
  curvedParts = 0.0;
  curvedNext = 0.0;
  isWithinCell = false;
#if RELEVO_FOLDED
  walkBefore = Nothing;
#endif
  if (isCurvedCell(walkCell))
  {
#if !RELEVO_CELL_SCALARS
    // The pieces of a corner's scalars are near those of the following scalars.
    uint near = wordOfCell(walkCell, 0);
    seekScalars(getPointScalars(near, texelFetch(meshPoints, int(near)).w));
#endif
    return;
  }
#endif
#if RELEVO_CORNER_SCALARS
  getWeights(faceAreas, walkWeights);
  // The pieces of a corner's scalars are near those of the following scalars.
  seekScalars(getCornerScalars(texelFetch(cornerScalars, int(walkCell)), 0));
#elif !RELEVO_CELL_SCALARS
  scalarsA = getPointScalars(faceA.id, texelFetch(meshPoints, int(faceA.id)).w);
  scalarsB = getPointScalars(faceB.id, texelFetch(meshPoints, int(faceB.id)).w);
  scalarsC = getPointScalars(faceC.id, texelFetch(meshPoints, int(faceC.id)).w);
  vec3 weights;
  getWeights(faceAreas, weights);
  walkScalars = interpolateScalars(weights);
  seekScalars(walkScalars);
#if RELEVO_LIT
  walkToGradients(uvec3(faceA.id, faceB.id, faceC.id), weights);
#endif
#endif
}

// Cross a tetrahedron to the face through which the ray leaves it.
void crossTetrahedron()
{
#if RELEVO_DISCONTINUOUS
  if (walkSide != SamePoints)
  {
    takeScalars();
  }
#endif
  uint id = texelFetch(pointSums, int(walkCell)).r ^ faceA.id ^ faceB.id ^ faceC.id;
  uvec4 behind = texelFetch(neighbors, int(walkCell));
  vec4 point = texelFetch(meshPoints, int(id));
  Corner d = Corner(id, seenAlongRay(point.xyz));
  vec3 areas = vec3(spannedArea(faceA.id, faceA.at.xy, d.id, d.at.xy),
    spannedArea(faceB.id, faceB.at.xy, d.id, d.at.xy),
    spannedArea(faceC.id, faceC.at.xy, d.id, d.at.xy));
  bool leftA = isOnLeft(areas.x, faceA.id, faceA.at.xy, d.id, d.at.xy);
  bool leftB = isOnLeft(areas.y, faceB.id, faceB.at.xy, d.id, d.at.xy);
  bool leftC = isOnLeft(areas.z, faceC.id, faceC.at.xy, d.id, d.at.xy);
  if (leftA == leftB && leftB == leftC)
  {
    // Due to rounding, the ray passes next to the corner. It is moved to the other side of the
    // nearest edge.
    vec3 sizes = abs(areas);
    leftA = leftA != (sizes.x <= sizes.y && sizes.x <= sizes.z);
    leftB = leftB != (sizes.y < sizes.x && sizes.y <= sizes.z);
    leftC = leftC != (sizes.z < sizes.x && sizes.z < sizes.y);
  }
#if RELEVO_CORNER_SCALARS
  // The corners' places in the order of the points.
  ivec3 isAbove = ivec3(greaterThan(uvec3(faceB.id, faceC.id, faceC.id),
    uvec3(faceA.id, faceA.id, faceB.id))); // B above A, C above A, C above B
  ivec3 isAboveD = ivec3(greaterThan(uvec3(faceA.id, faceB.id, faceC.id), uvec3(id)));
  ivec3 places = isAboveD +
    ivec3(2 - isAbove.x - isAbove.y, 1 + isAbove.x - isAbove.z, isAbove.y + isAbove.z);
  int placeD = 3 - isAboveD.x - isAboveD.y - isAboveD.z;
  vec4 all = texelFetch(cornerScalars, int(walkCell));
  scalarsA = getCornerScalars(all, places.x);
  scalarsB = getCornerScalars(all, places.y);
  scalarsC = getCornerScalars(all, places.z);
  Scalars scalarsD = getCornerScalars(all, placeD);
  jumpTo(interpolateScalars(walkWeights));
#if RELEVO_LIT
  walkToGradients(uvec3(4 * int(walkCell) + places), walkWeights);
#endif
#elif !RELEVO_CELL_SCALARS
  Scalars scalarsD = getPointScalars(id, point.w);
#endif
#if RELEVO_STEEPNESS
  setSteepness(faceA.at - d.at, faceB.at - d.at, faceC.at - d.at, scalarsA - scalarsD,
    scalarsB - scalarsD, scalarsC - scalarsD);
#endif
  // The new corner replaces the one opposite to the exit.
  bool isC = leftB && !leftA;
  bool isA = !isC && leftC && !leftB;
  bool isB = !isC && !isA;
  uint across = isA ? faceA.id : isB ? faceB.id : faceC.id;
  faceAreas = isA ? vec3(faceAreas.x, areas.z, -areas.y)
    : isB         ? vec3(-areas.z, faceAreas.y, areas.x)
                  : vec3(areas.y, -areas.x, faceAreas.z);
  faceA = isA ? d : faceA;
  faceB = isB ? d : faceB;
  faceC = isC ? d : faceC;
#if !RELEVO_CELL_SCALARS
  scalarsA = isA ? scalarsD : scalarsA;
  scalarsB = isB ? scalarsD : scalarsB;
  scalarsC = isC ? scalarsD : scalarsC;
#endif
  vec3 weights;
  bool isSeen = getWeights(faceAreas, weights);
  float exit = isSeen ? interpolateDepth(faceA, faceB, faceC, weights) : walkDepth;
#if RELEVO_CELL_SCALARS
  Scalars scalars = getCellScalars(walkCell);
  seekScalars(scalars);
  beginPart(walkDepth, exit, scalars, scalars);
#else
  Scalars front = walkScalars;
  if (isSeen)
  {
    walkScalars = interpolateScalars(weights);
  }
  beginPart(walkDepth, exit, front, walkScalars);
#endif
#if RELEVO_CORNER_SCALARS
  walkWeights = isSeen ? weights : vec3(1.0, 0.0, 0.0);
  int place = isA ? places.x : isB ? places.y : places.z;
  places = isA ? ivec3(placeD, places.yz)
    : isB      ? ivec3(places.x, placeD, places.z)
               : ivec3(places.xy, placeD);
  uvec3 ids = uvec3(4 * int(walkCell) + places);
#else
  int place = int(faceA.id < across) + int(faceB.id < across) + int(faceC.id < across);
  uvec3 ids = uvec3(faceA.id, faceB.id, faceC.id);
#endif
#if RELEVO_LIT
  // assigned one by one, because Mesa 26 copies arrays incorrectly
  vec3 frontGradients[RELEVO_MATERIALS];
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    frontGradients[i] = walkGradients[i];
  }
  if (isSeen)
  {
    walkToGradients(ids, weights);
  }
  setPartGradients(walkDepth, exit, frontGradients);
#endif
  walkDepth = exit;
  moveTo(place == 0 ? behind.x : place == 1 ? behind.y : place == 2 ? behind.z : behind.w);
}

//RELEVO::CurvedWalk

float walkOpacity = Opaque; // of the collected colour, at which the walk ends

bool isWalkOver()
{
  return walkDone >= walkEnd || collected.a >= walkOpacity;
}

#if RELEVO_CURVED
// The whole cell is processed before the next one, because crossing a cell takes long.
void walkFrom(Entry entry)
{
  enterMesh(entry);
  for (int step = 0; step < maximumSteps && walkCell != Nothing && !isWalkOver(); ++step)
  {
    if (isCurvedCell(walkCell))
    {
      crossCurved();
      isPartDone = true;
    }
    else
    {
      crossTetrahedron();
      curvedParts = 0.0;
    }
    while ((!isPartDone || curvedNext < curvedParts) && collected.a < walkOpacity)
    {
      if (isPartDone)
      {
        nextCurvedPart();
      }
      if (!isPartDone)
      {
        isPartDone = collect(partFront, partBack, partSpan, partFrom);
      }
    }
  }
}
#else
// An iteration is a step, a piece of a segment, or both, so that neighbouring rays stay
// synchronized.
void walkFrom(Entry entry)
{
  enterMesh(entry);
  isPartDone = true;
  int step = 0;
  while (collected.a < walkOpacity)
  {
    if (isPartDone)
    {
      if (walkCell == Nothing || walkDone >= walkEnd || step == maximumSteps)
      {
        break;
      }
      crossTetrahedron();
      ++step;
    }
    if (!isPartDone)
    {
      isPartDone = collect(partFront, partBack, partSpan, partFrom);
    }
  }
}
#endif
