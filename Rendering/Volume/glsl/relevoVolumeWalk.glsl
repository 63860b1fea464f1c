// The walk from tetrahedron to tetrahedron. A face is left through when the ray, as it sees the
// edges, is inside it: both cells of a face see the same, so no ray gets lost between them or turns
// back, whatever the cells' shapes.
//
// M. Weiler, M. Kraus, M. Merz, T. Ertl, "Hardware-Based Ray Casting for Tetrahedral Meshes", IEEE
// Visualization 2003, with one point and three areas a step in place of four planes.

uniform usamplerBuffer pointSums;
uniform usamplerBuffer neighbors;
uniform samplerBuffer pointScalars;
uniform samplerBuffer cellScalars;
uniform int maximumSteps;

const uint Nothing = 0xffffffffu;

// Where the walk is: the cell that comes next, and the face through which it is entered.
uint walkCell;
float walkDepth;
Corner faceA;
Corner faceB;
Corner faceC;
vec3 faceAreas; // spanned by the edges across from the corners

Scalars walkScalars; // there

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
Scalars scalarsA;
Scalars scalarsB;
Scalars scalarsC;

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
  return weights.x * scalarsA + weights.y * scalarsB + weights.z * scalarsC;
}
#endif

#if RELEVO_CURVED
float curvedParts = 0.0; // that a cell is shown in
float curvedNext = 0.0;  // of them
bool isWithinCell = false; // the last step ended before the cell does
#if RELEVO_FOLDED
uint walkBefore = Nothing; // the cell that the walk has come from
#endif
#endif

void enterMesh(Entry entry)
{
  walkCell = entry.cell;
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
    // Those of a corner are near to those that come.
    uint near = wordOfCell(walkCell, 0);
    seekScalars(getPointScalars(near, texelFetch(meshPoints, int(near)).w));
#endif
    return;
  }
#endif
#if !RELEVO_CELL_SCALARS
  scalarsA = getPointScalars(faceA.id, texelFetch(meshPoints, int(faceA.id)).w);
  scalarsB = getPointScalars(faceB.id, texelFetch(meshPoints, int(faceB.id)).w);
  scalarsC = getPointScalars(faceC.id, texelFetch(meshPoints, int(faceC.id)).w);
  vec3 weights;
  getWeights(faceAreas, weights);
  walkScalars = interpolateScalars(weights);
  seekScalars(walkScalars);
#endif
#if RELEVO_LIT
  walkToGradients(uvec3(faceA.id, faceB.id, faceC.id), weights);
#endif
}

// Through a tetrahedron to the face that the ray leaves it by.
void crossTetrahedron()
{
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
    // Rounding: the ray passes next to the corner. It is taken to be on the other side of the
    // nearest edge.
    vec3 sizes = abs(areas);
    leftA = leftA != (sizes.x <= sizes.y && sizes.x <= sizes.z);
    leftB = leftB != (sizes.y < sizes.x && sizes.y <= sizes.z);
    leftC = leftC != (sizes.z < sizes.x && sizes.z < sizes.y);
  }
#if !RELEVO_CELL_SCALARS
  Scalars scalarsD = getPointScalars(id, point.w);
#endif
#if RELEVO_STEEPNESS
  setSteepness(faceA.at - d.at, faceB.at - d.at, faceC.at - d.at, scalarsA - scalarsD,
    scalarsB - scalarsD, scalarsC - scalarsD);
#endif
  // The new corner takes the place of the one across from the exit.
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
#if RELEVO_LIT
  vec3 frontGradients[RELEVO_MATERIALS]; // one by one: Mesa 26 copies arrays wrongly
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    frontGradients[i] = walkGradients[i];
  }
  if (isSeen)
  {
    walkToGradients(uvec3(faceA.id, faceB.id, faceC.id), weights);
  }
  setPartGradients(walkDepth, exit, frontGradients);
#endif
  walkDepth = exit;
  int place = int(faceA.id < across) + int(faceB.id < across) + int(faceC.id < across);
  walkCell = place == 0 ? behind.x : place == 1 ? behind.y : place == 2 ? behind.z : behind.w;
}

//RELEVO::CurvedWalk

bool isWalkOver()
{
  return walkDone >= walkEnd || collected.a >= Opaque;
}

#if RELEVO_CURVED
// All that is in a cell before the next one, as to cross it takes long.
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
    while ((!isPartDone || curvedNext < curvedParts) && collected.a < Opaque)
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
// One round may be a step, or a piece of a part, or both: rays next to each other keep pace.
void walkFrom(Entry entry)
{
  enterMesh(entry);
  isPartDone = true;
  int step = 0;
  while (collected.a < Opaque)
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
