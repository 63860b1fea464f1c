// The height of a vertex of a face, which equals that of FaceHeights.cxx to the bit. Follows
// relevoTerrainFaceVS.glsl.

uniform sampler2DArray relevoTiles; // tiles of heights, each with a ring of one more vertex around

// Powers of 2, because OpenGL rounds divisions differently.
const float relevoFractions[10] = float[](
  1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0078125, 0.00390625, 0.001953125);

float relevoMix(float a, float b, float t)
{
  precise float mixed = a + t * (b - a);
  return mixed;
}

float relevoTexel(RelevoTile tile, ivec2 vertex)
{
  return texelFetch(relevoTiles, ivec3(vertex + ivec2(1), tile.Layer), 0).r;
}

// GetLatticeHeight(). Vertices without weight may lack data. Loops skip them faster than branches do
// on processors that execute both branches.
float relevoLatticeHeight(RelevoTile tile, ivec2 vertex)
{
  ivec2 inTile = (vertex >> tile.Shift) - tile.First;
  vec2 weights = vec2(vertex & ivec2((1 << tile.Shift) - 1)) * relevoFractions[tile.Shift];
  int columns = weights.x > 0.0 ? 2 : 1;
  int rows = weights.y > 0.0 ? 2 : 1;
  float value = 0.0;
  float inRow = 0.0;
  int i = 0;
  do
  {
    int column = i & (columns - 1);
    int row = i >> (columns - 1);
    float here = relevoTexel(tile, inTile + ivec2(column, row));
    inRow = column == 0 ? here : relevoMix(inRow, here, weights.x);
    if (column == columns - 1)
    {
      value = row == 0 ? inRow : relevoMix(value, inRow, weights.y);
    }
    ++i;
  } while (i < columns * rows);
  return value;
}

// GetFine() and GetCoarse()
float relevoSurface(bool isCoarse, ivec2 ab)
{
  RelevoTile tile = relevoFineTile;
  ivec2 vertex = relevoFaceVertex(ab);
  if (isCoarse)
  {
    tile = relevoCoarseTile;
    vertex /= 2;
  }
  return relevoLatticeHeight(tile, vertex);
}

float relevoHeight(ivec2 ab)
{
  int sum = ab.x + ab.y;
  bool isOnLongestSide = sum == RELEVO_SEGMENTS;
  bool isMorphed = relevoMorph < 1.0 && !isOnLongestSide;
  bool isEven = sum % 2 == 0;
  // The target, and one or two vertices of the source.
  int number = isMorphed ? (isEven ? 2 : 3) : 1;
  float target = 0.0;
  precise float source = 0.0;
  int i = 0;
  do
  {
    ivec2 here = i == 0 || isEven ? ab : ab + (2 * i - 3) * (ab & ivec2(1));
    bool isCoarse = relevoSquare && (i > 0 || isOnLongestSide) || i > 0 && here.y == 0;
    float value = relevoSurface(isCoarse, here);
    if (i > 0 && here.x == RELEVO_SEGMENTS)
    {
      value = relevoCorners.y; // a corner of the parent
    }
    else if (i > 0 && here.y == RELEVO_SEGMENTS)
    {
      value = relevoCorners.z;
    }
#ifdef RELEVO_GLOBE
    if (i > 0 && !isEven)
    {
      vec3 point = relevoGlobePoint(here, value);
      relevoMidpoint = i == 1 ? point : 0.5 * (relevoMidpoint + point);
    }
#endif
    target = i == 0 ? value : target;
    source = i == 1 ? value : source;
    if (i == 2)
    {
      source = 0.5 * (source + value);
    }
    ++i;
  } while (i < number);
#ifdef RELEVO_GLOBE
  bool moves = isMorphed && !isEven && !isnan(source);
  if (moves)
  {
    vec3 point = relevoGlobePoint(ab, target);
    precise vec3 moved = relevoMidpoint + relevoMorph * (point - relevoMidpoint);
    relevoGlobePosition = moved;
  }
#endif
  if (isMorphed && !isnan(source))
  {
    target = relevoMix(source, target, relevoMorph);
  }
  if (sum == 0)
  {
    target = relevoCorners.x;
  }
  else if (ab.x == RELEVO_SEGMENTS)
  {
    target = relevoCorners.y;
  }
  else if (ab.y == RELEVO_SEGMENTS)
  {
    target = relevoCorners.z;
  }
#ifdef RELEVO_GLOBE
  if (!moves)
  {
    relevoGlobePosition = relevoGlobePoint(ab, target);
  }
#endif
  return target;
}
