//VTK::System::Dec
//RELEVO::Defines
// The projected outline of each border face: a triangle or a rectangle.

uniform samplerBuffer meshPoints;
uniform usamplerBuffer borderFaces;

//RELEVO::Outline
//RELEVO::Cells

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
  for (int i = 0; i < 3; ++i)
  {
    vec4 seen = seePoint(ids[i]);
    surround(seen);
    places[i] = seen.xy / seen.w;
  }
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

void main()
{
  face = gl_VertexID / 4;
  int corner = gl_VertexID % 4;
  uvec4 words = texelFetch(borderFaces, face);
#if RELEVO_CURVED
  if (isCurvedCell(words.w))
  {
    gl_Position = placeOnScreen(getCurvedCorner(words.w, int(words.x), corner));
    return;
  }
#endif
  gl_Position = placeOnScreen(getTriangleCorner(words.xyz, corner));
}
