// Finds where the ray enters the mesh: border faces in a tree of boxes. The ray enters through each
// of them once, in the order of depth.

uniform samplerBuffer borderTree;
uniform int treeSize;

//RELEVO::Starts

struct Entry
{
  float depth;
  int face;
  uint cell;
  Corner a;
  Corner b;
  Corner c;
  vec3 areas; // spanned by the edges opposite to a, b and c
};

// Return an entry before the first one.
Entry noEntry()
{
  return Entry(-1e30, -1, 0u, NoCorner, NoCorner, NoCorner, vec3(0.0));
}

#if RELEVO_SAME_SUMS
// Sums in the order of the values do not depend on the cell or the piece of the mesh.
float sumInOrder(vec3 values)
{
  float low = min(values.x, values.y);
  float high = max(values.x, values.y);
  RELEVO_PRECISE float two = min(low, values.z) + max(high, values.z);
  RELEVO_PRECISE float three = two + max(low, min(high, values.z));
  return three;
}
#endif

// Interpolate the depth of a face's corners by weights.
float interpolateDepth(Corner a, Corner b, Corner c, vec3 weights)
{
#if RELEVO_SAME_SUMS
  RELEVO_PRECISE vec3 parts = weights * vec3(a.at.z, b.at.z, c.at.z);
  return sumInOrder(parts);
#else
  return dot(weights, vec3(a.at.z, b.at.z, c.at.z));
#endif
}

// Compute the weights of the corners where the ray crosses a face. Return false if the face is seen
// edge-on.
bool getWeights(vec3 areas, out vec3 weights)
{
  vec3 sizes = max(areas, vec3(0.0));
#if RELEVO_SAME_SUMS
  float sum = sumInOrder(sizes);
#else
  float sum = sizes.x + sizes.y + sizes.z;
#endif
  weights = sizes / sum;
  return sum > 0.0;
}

bool isBefore(float depthA, int faceA, float depthB, int faceB)
{
  return depthA < depthB || (depthA == depthB && faceA < faceB);
}

#if RELEVO_CURVED
#if RELEVO_FOLDED
// Find the next entry of the ray through a folded face. Return false if there is none.
bool entersFold(int face, bool isQuadratic, Corner border[6], float lastDepth, int lastFace,
  out float depth)
{
  bool isFound = false;
  depth = 0.0;
  for (int i = 0; i < foldCount; ++i)
  {
    float at = depthOnFace(isQuadratic, border, foldPlaces[i]);
    if (foldTurns[i] < 0.0 && isBefore(lastDepth, lastFace, at, face) && (!isFound || at < depth))
    {
      isFound = true;
      depth = at;
    }
  }
  return isFound;
}
#endif

bool entersCurved(int face, uvec4 words, float lastDepth, int lastFace, inout Entry entry)
{
  bool isQuadratic = isQuadraticCell(words.w);
  int size = sizeOfBorder(isQuadratic);
  Corner border[6];
#if RELEVO_QUADRATIC
  for (int i = 0; i < size; ++i)
  {
    border[i] = getCorner(wordOfCell(words.w, cornerOfFace(isQuadratic, int(words.x), i)));
  }
#else
  uvec4 points = pointsOfHexFace(words.w, int(words.x));
  for (int i = 0; i < 4; ++i)
  {
    border[i] = getCorner(points[i]);
  }
#endif
#if RELEVO_HANGING
  int winding = windingOfFace(words.w, int(words.x), border);
#else
  int winding = windingOf(border, size);
#endif
#if RELEVO_FOLDED
  foldCount = 0;
  if (isQuadratic)
  {
#if RELEVO_QUADRATIC
    foldQuadratic(border, winding);
#endif
  }
  else if (winding == 0)
  {
    foldBilinear(border[0].at.xy, border[1].at.xy, border[2].at.xy, border[3].at.xy);
  }
  if (foldCount > 0)
  {
    float depth;
    bool isFound = entersFold(face, isQuadratic, border, lastDepth, lastFace, depth);
    entry.depth = isFound ? depth : entry.depth;
    entry.face = isFound ? face : entry.face;
    entry.cell = isFound ? words.w : entry.cell;
    return isFound;
  }
#endif
  if (winding >= 0)
  {
    return false;
  }
  vec3 parameters;
  entry.depth = crossFace(isQuadratic, int(words.x), border, parameters);
  entry.face = face;
  entry.cell = words.w;
  return true;
}
#endif

// Return whether the ray enters through a face, and compute the first entry after the given one.
bool enters(int face, float lastDepth, int lastFace, inout Entry entry)
{
  uvec4 words = wordsOfFace(face);
#if RELEVO_CURVED
  if (isCurvedCell(words.w))
  {
    return entersCurved(face, words, lastDepth, lastFace, entry);
  }
#endif
  Corner a = getCorner(words.x);
  Corner b = getCorner(words.y);
  Corner c = getCorner(words.z);
  vec3 areas = vec3(spannedArea(b.id, b.at.xy, c.id, c.at.xy),
    spannedArea(c.id, c.at.xy, a.id, a.at.xy), spannedArea(a.id, a.at.xy, b.id, b.at.xy));
  vec3 weights;
  if (!isOnLeft(areas.x, b.id, b.at.xy, c.id, c.at.xy) ||
    !isOnLeft(areas.y, c.id, c.at.xy, a.id, a.at.xy) ||
    !isOnLeft(areas.z, a.id, a.at.xy, b.id, b.at.xy) || !getWeights(areas, weights))
  {
    return false;
  }
  entry = Entry(interpolateDepth(a, b, c, weights), face, words.w, a, b, c, areas);
  return true;
}

// Find the next entry after the given one, up to the end. The search begins with a face that is
// probably the result; -1 for none. Intersections of faces are in one place, because shaders take
// long to compile.
bool findEntry(float end, int guess, inout Entry entry)
{
  vec3 way = mix(rayDirection, vec3(1e-20), lessThan(abs(rayDirection), vec3(1e-20)));
  vec3 inverse = vec3(1.0) / way;
  float lastDepth = entry.depth;
  int lastFace = entry.face;
  float nearest = end;
  int nearestFace = -1;
  int node = guess < 0 ? 0 : -1;
  while (node < treeSize)
  {
    bool isGuess = node < 0;
    vec4 low = texelFetch(borderTree, 2 * max(node, 0));
    vec4 high = texelFetch(borderTree, 2 * max(node, 0) + 1);
    vec3 a = (low.xyz - rayOrigin) * inverse;
    vec3 b = (high.xyz - rayOrigin) * inverse;
    vec3 first = min(a, b);
    vec3 last = max(a, b);
    float begin = max(max(first.x, first.y), first.z);
    float close = min(min(last.x, last.y), last.z);
    bool hits = isGuess || (begin <= close && close >= lastDepth && begin <= nearest);
    int count = isGuess ? 1 : int(high.w);
    int firstFace = isGuess ? guess : int(low.w);
    node = hits || count > 0 ? node + 1 : int(low.w);
    for (int face = firstFace; hits && face < firstFace + count; ++face)
    {
      Entry candidate = entry;
      if (enters(face, lastDepth, lastFace, candidate) && isBefore(lastDepth, lastFace, candidate.depth, face) &&
        (nearestFace < 0 ? candidate.depth <= nearest
                         : isBefore(candidate.depth, face, nearest, nearestFace)))
      {
        entry = candidate;
        nearest = candidate.depth;
        nearestFace = face;
        node = isGuess ? treeSize : node;
      }
    }
  }
  return nearestFace >= 0;
}

// The sum of the indices of the faces through which the ray enters, and their number. If the number
// is one, the sum is the face.
uniform sampler2D rayEntries;
uniform int areEntriesKnown;

// Return an upper bound for the number of entries, and set the face of the first one if it is known,
// or -1.
int countEntries(out int first)
{
  first = -1;
  if (areEntriesKnown == 0)
  {
    return treeSize * 16;
  }
  vec2 known = texelFetch(rayEntries, ivec2(gl_FragCoord.xy - viewportRectangle.xy), 0).rg;
  first = known.y == 1.0 ? int(known.x) : -1;
  return int(known.y);
}
