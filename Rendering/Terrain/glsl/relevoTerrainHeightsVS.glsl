// The height of a vertex of a face, and its derivatives by the raster's column and row. The heights
// equal those of FaceHeights.cxx to the bit. Follows relevoTerrainFaceVS.glsl.

uniform sampler2DArray relevoTiles; // tiles of heights, each with a ring of one more vertex around

// Powers of 2, because OpenGL rounds divisions differently.
const float relevoFractions[6] = float[](1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125);

vec3 relevoMix(vec3 a, vec3 b, float t)
{
  precise vec3 mixed = a + t * (b - a);
  return mixed;
}

float relevoTexel(RelevoTile tile, ivec2 vertex)
{
  return texelFetch(relevoTiles, ivec3(vertex + ivec2(1), tile.Layer), 0).r;
}

// Return the central difference, or a difference of two if one neighbour has no data.
float relevoDifference(float before, float here, float after)
{
  if (isnan(before))
  {
    return isnan(after) ? 0.0 : after - here;
  }
  return isnan(after) ? here - before : 0.5 * (after - before);
}

vec3 relevoTileVertex(RelevoTile tile, ivec2 vertex)
{
  float height = relevoTexel(tile, vertex);
  vec2 differences = vec2(
    relevoDifference(relevoTexel(tile, vertex - ivec2(1, 0)), height,
      relevoTexel(tile, vertex + ivec2(1, 0))),
    relevoDifference(relevoTexel(tile, vertex - ivec2(0, 1)), height,
      relevoTexel(tile, vertex + ivec2(0, 1))));
  return vec3(height, differences * tile.VerticesPerSample);
}

// GetLatticeHeight(). Vertices without weight may lack data. Loops skip them faster than branches do
// on processors that execute both branches.
vec3 relevoLatticeVertex(RelevoTile tile, ivec2 vertex)
{
  ivec2 inTile = (vertex >> tile.Shift) - tile.First;
  vec2 weights = vec2(vertex & ivec2((1 << tile.Shift) - 1)) * relevoFractions[tile.Shift];
  int columns = weights.x > 0.0 ? 2 : 1;
  int rows = weights.y > 0.0 ? 2 : 1;
  vec3 value = vec3(0.0);
  vec3 inRow = vec3(0.0);
  int i = 0;
  do
  {
    int column = i & (columns - 1);
    int row = i >> (columns - 1);
    vec3 here = relevoTileVertex(tile, inTile + ivec2(column, row));
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
vec3 relevoSurface(bool isCoarse, ivec2 ab)
{
  RelevoTile tile = relevoFineTile;
  ivec2 vertex = relevoFaceVertex(ab);
  if (isCoarse)
  {
    tile = relevoCoarseTile;
    vertex /= 2;
  }
  return relevoLatticeVertex(tile, vertex);
}

vec3 relevoVertex(ivec2 ab)
{
  int sum = ab.x + ab.y;
  bool isOnLongestSide = sum == RELEVO_SEGMENTS;
  bool isMorphed = relevoMorph < 1.0 && !isOnLongestSide;
  bool isEven = sum % 2 == 0;
  // The target, and one or two vertices of the source.
  int number = isMorphed ? (isEven ? 2 : 3) : 1;
  vec3 target = vec3(0.0);
  precise vec3 source = vec3(0.0);
  int i = 0;
  do
  {
    ivec2 here = i == 0 || isEven ? ab : ab + (2 * i - 3) * (ab & ivec2(1));
    bool isCoarse = relevoSquare && (i > 0 || isOnLongestSide) || i > 0 && here.y == 0;
    vec3 value = relevoSurface(isCoarse, here);
    if (i > 0 && here.x == RELEVO_SEGMENTS)
    {
      value.x = relevoCorners.y; // a corner of the parent
    }
    else if (i > 0 && here.y == RELEVO_SEGMENTS)
    {
      value.x = relevoCorners.z;
    }
    target = i == 0 ? value : target;
    source = i == 1 ? value : source;
    if (i == 2)
    {
      source = 0.5 * (source + value);
    }
    ++i;
  } while (i < number);
  if (isMorphed && !isnan(source.x))
  {
    target = relevoMix(source, target, relevoMorph);
  }
  if (sum == 0)
  {
    target.x = relevoCorners.x;
  }
  else if (ab.x == RELEVO_SEGMENTS)
  {
    target.x = relevoCorners.y;
  }
  else if (ab.y == RELEVO_SEGMENTS)
  {
    target.x = relevoCorners.z;
  }
  return target;
}
