// The outline of a face where rays may enter, and the depth of its plane.

const float Sharp = 0.02; // twice the area, relative to the size

bool isFaceUnseen = false;
bool isRectangle = true; // around the face; otherwise its outline is the triangle
float faceWinding = 0.0;
vec2 trianglePlaces[3];

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

#if RELEVO_PLANES
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
// The outline is the rectangle around the face's corners, or around the Bezier points of a
// quadratic face. The orientation of a bilinear face is bilinear: if its corners are seen from
// inside, so is the whole face.
#if RELEVO_QUADRATIC
void findQuadraticFace(uint cell, int number)
{
  vec4 border[6];
  for (int i = 0; i < 6; ++i)
  {
    border[i] = seePoint(wordOfCell(cell, cornerOfFace(true, number, i)));
  }
  for (int i = 0; i < 6; ++i)
  {
    surround(
      i % 2 == 1 ? 2.0 * border[i] - 0.5 * (border[i - 1] + border[(i + 1) % 6]) : border[i]);
  }
#if RELEVO_PLANES
  findPlane(border[0], border[2], border[4], border[4]);
#endif
}
#endif

void findCurvedFace(uint cell, int number)
{
#if RELEVO_QUADRATIC
  if (isQuadraticCell(cell))
  {
    findQuadraticFace(cell, number);
    return;
  }
#endif
  uvec4 points = pointsOfHexFace(cell, number);
  vec4 border[4];
  for (int i = 0; i < 4; ++i)
  {
    border[i] = seePoint(points[i]);
    surround(border[i]);
  }
#if RELEVO_PLANES
  findPlane(border[0], border[1], border[2], border[3]);
#endif
  isFaceUnseen = true;
  for (int i = 0; i < 4 && isFaceUnseen; ++i)
  {
    vec4 a = border[(i + 3) % 4];
    vec4 b = border[i];
    vec4 c = border[(i + 1) % 4];
    isFaceUnseen = isSeenFromInside(-windingOf(a.xy / a.w, b.xy / b.w, c.xy / c.w));
  }
}
#endif

void findTriangle(uvec3 ids)
{
  vec4 seen[3];
  for (int i = 0; i < 3; ++i)
  {
    seen[i] = seePoint(ids[i]);
    surround(seen[i]);
    trianglePlaces[i] = seen[i].xy / seen[i].w;
  }
#if RELEVO_PLANES
  findPlane(seen[0], seen[1], seen[2], seen[2]);
#endif
  faceWinding = windingOf(trianglePlaces[0], trianglePlaces[1], trianglePlaces[2]);
  isFaceUnseen = isSeenFromInside(faceWinding);
  isRectangle = isUnclear(faceWinding);
}

void findFace(uvec4 words)
{
#if RELEVO_CURVED
  if (isCurvedCell(words.w))
  {
    findCurvedFace(words.w, int(words.x));
    return;
  }
#endif
  findTriangle(words.xyz);
}

// Return a corner of the outline, 0 to 3, after findFace().
vec2 getFaceCorner(int corner)
{
  int at = min(corner, 2);
  return isFaceUnseen ? Unseen
    : isRectangle
    ? getRectangleCorner(corner, Margin)
    : widen(trianglePlaces[(at + 2) % 3], trianglePlaces[at], trianglePlaces[(at + 1) % 3],
        faceWinding);
}
