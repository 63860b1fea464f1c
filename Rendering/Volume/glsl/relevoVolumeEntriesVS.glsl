//VTK::System::Dec
//RELEVO::Defines
// For each border face the rectangle around it on the screen, of two triangles, a pixel wider than
// it has to be: which pixels' rays go through the face is for the fragment shader to say.

uniform samplerBuffer meshPoints;
uniform usamplerBuffer borderFaces;
uniform mat4 meshToClip;
uniform vec2 pixelSize; // in clip coordinates

//RELEVO::Cells

flat out int face;

vec2 low = vec2(1e30);
vec2 high = vec2(-1e30);

vec3 placeOf(uint point)
{
  return texelFetch(meshPoints, int(point)).xyz;
}

void surround(vec3 place)
{
  vec4 seen = meshToClip * vec4(place, 1.0);
  low = min(low, seen.xy / seen.w);
  high = max(high, seen.xy / seen.w);
}

#if RELEVO_CURVED
// Its corners, of a quadratic face the Bezier points.
void surroundCurved(uint cell, int number)
{
  bool isQuadratic = isQuadraticCell(cell);
  int size = sizeOfBorder(isQuadratic);
  vec3 border[6];
  for (int i = 0; i < size; ++i)
  {
    border[i] = placeOf(wordOfCell(cell, cornerOfFace(isQuadratic, number, i)));
  }
  for (int i = 0; i < size; ++i)
  {
    bool isMiddle = isQuadratic && i % 2 == 1;
    surround(
      isMiddle ? 2.0 * border[i] - 0.5 * (border[i - 1] + border[(i + 1) % size]) : border[i]);
  }
}
#endif

void main()
{
  face = gl_VertexID / 6;
  uvec4 words = texelFetch(borderFaces, face);
#if RELEVO_CURVED
  if (isCurvedCell(words.w))
  {
    surroundCurved(words.w, int(words.x));
  }
  else
#endif
  {
    surround(placeOf(words.x));
    surround(placeOf(words.y));
    surround(placeOf(words.z));
  }
  int corner = gl_VertexID % 6;
  bool isRight = corner == 1 || corner == 2 || corner == 4;
  bool isUpper = corner == 2 || corner == 4 || corner == 5;
  gl_Position = vec4(isRight ? high.x + pixelSize.x : low.x - pixelSize.x,
    isUpper ? high.y + pixelSize.y : low.y - pixelSize.y, 0.0, 1.0);
}
