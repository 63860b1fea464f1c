//VTK::System::Dec
//RELEVO::Defines
// The projected outline of each face where rays may enter: a triangle or a rectangle.

uniform samplerBuffer meshPoints;

//RELEVO::Outline
//RELEVO::Cells
//RELEVO::Starts

flat out int face;

const float Sharp = 0.02; // twice the area, relative to the size

vec4 seePoint(uint point)
{
  return meshToSeen * vec4(texelFetch(meshPoints, int(point)).xyz, 1.0);
}

// Return whether a face, or a part of it, is too thin or small to determine its orientation.
bool isUnclear(float winding)
{
  vec2 size = high - low;
  return abs(winding) <= Sharp * (dot(size, size) + Margin);
}

// Seen by an entering ray, triangles are counterclockwise, and faces of cells clockwise.
bool isSeenFromInside(float winding)
{
  return winding * determinant(meshToSeen) < 0.0 && !isUnclear(winding);
}

#if RELEVO_ACTIVE
uniform float depthScale; // makes depths of the mesh between -1 and 1

// The depth of the face's plane: the value at the origin, and the slopes.
vec3 plane = vec3(0.0);

// Find the plane of a face with these corners. The last two may be one point.
void findPlane(vec4 a, vec4 b, vec4 c, vec4 d)
{
  vec3 corners[4] = vec3[4](a.xyz / a.w, b.xyz / b.w, c.xyz / c.w, d.xyz / d.w);
  vec3 first = corners[2] - corners[0];
  vec3 last = corners[3] - corners[1];
  float area = first.x * last.y - first.y * last.x;
  vec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  vec2 slope = isUnclear(area) ? vec2(0.0)
                               : vec2(first.z * last.y - last.z * first.y,
                                   last.z * first.x - first.z * last.x) / area;
  plane = depthScale * vec3(middle.z - dot(slope, middle.xy), slope);
}
#endif

#if RELEVO_CURVED
// Return a corner of the rectangle around a face's corners, or around the Bezier points of a
// quadratic face. The orientation of a bilinear face is bilinear: if its corners are seen from
// inside, so is the whole face.
vec2 getCurvedCorner(uint cell, int number, int corner)
{
  bool isQuadratic = isQuadraticCell(cell);
  int size = sizeOfBorder(isQuadratic);
  vec4 border[6];
  for (int i = 0; i < size; ++i)
  {
    border[i] = seePoint(wordOfCell(cell, cornerOfFace(isQuadratic, number, i)));
  }
  for (int i = 0; i < size; ++i)
  {
    bool isMiddle = isQuadratic && i % 2 == 1;
    surround(
      isMiddle ? 2.0 * border[i] - 0.5 * (border[i - 1] + border[(i + 1) % size]) : border[i]);
  }
#if RELEVO_ACTIVE
  if (isQuadratic)
  {
    findPlane(border[0], border[2], border[4], border[4]);
  }
  else
  {
    findPlane(border[0], border[1], border[2], border[3]);
  }
#endif
  bool isInside = !isQuadratic;
  for (int i = 0; i < 4 && isInside; ++i)
  {
    vec4 a = border[(i + 3) % 4];
    vec4 b = border[i];
    vec4 c = border[(i + 1) % 4];
    isInside = isSeenFromInside(-windingOf(a.xy / a.w, b.xy / b.w, c.xy / c.w));
  }
  return isInside ? Unseen : getRectangleCorner(corner, Margin);
}
#endif

// Return a corner of a triangle's own outline.
vec2 getTriangleCorner(uvec3 ids, int corner)
{
  vec2 places[3];
  vec4 seen[3];
  for (int i = 0; i < 3; ++i)
  {
    seen[i] = seePoint(ids[i]);
    surround(seen[i]);
    places[i] = seen[i].xy / seen[i].w;
  }
#if RELEVO_ACTIVE
  findPlane(seen[0], seen[1], seen[2], seen[2]);
#endif
  float winding = windingOf(places[0], places[1], places[2]);
  if (isSeenFromInside(winding))
  {
    return Unseen;
  }
  int at = min(corner, 2);
  return isUnclear(winding)
    ? getRectangleCorner(corner, Margin)
    : widen(places[(at + 2) % 3], places[at], places[(at + 1) % 3], winding);
}

vec2 getCorner(uvec4 words, int corner)
{
#if RELEVO_CURVED
  if (isCurvedCell(words.w))
  {
    return getCurvedCorner(words.w, int(words.x), corner);
  }
#endif
  return getTriangleCorner(words.xyz, corner);
}

void main()
{
  face = gl_VertexID / 4;
  int corner = gl_VertexID % 4;
  uvec4 words = wordsOfFace(face);
  vec2 place = getCorner(words, corner);
  gl_Position = placeOnScreen(place);
#if RELEVO_ACTIVE
  gl_Position.z = plane.x + dot(plane.yz, place);
#endif
}
