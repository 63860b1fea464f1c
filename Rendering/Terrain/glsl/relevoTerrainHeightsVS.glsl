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

// Vertices without weight may lack data.
vec3 relevoTileRow(RelevoTile tile, ivec2 vertex, float u)
{
  vec3 value = relevoTileVertex(tile, vertex);
  if (u > 0.0)
  {
    value = relevoMix(value, relevoTileVertex(tile, vertex + ivec2(1, 0)), u);
  }
  return value;
}

// GetLatticeHeight()
vec3 relevoLatticeVertex(RelevoTile tile, ivec2 vertex)
{
  ivec2 inTile = (vertex >> tile.Shift) - tile.First;
  vec2 weights = vec2(vertex & ivec2((1 << tile.Shift) - 1)) * relevoFractions[tile.Shift];
  vec3 value = relevoTileRow(tile, inTile, weights.x);
  if (weights.y > 0.0)
  {
    value = relevoMix(value, relevoTileRow(tile, inTile + ivec2(0, 1), weights.x), weights.y);
  }
  return value;
}

vec3 relevoFine(ivec2 ab)
{
  return relevoLatticeVertex(relevoFineTile, relevoFaceVertex(ab));
}

vec3 relevoCoarse(ivec2 ab)
{
  return relevoLatticeVertex(relevoCoarseTile, relevoFaceVertex(ab) / 2);
}

vec3 relevoSource(ivec2 ab)
{
  vec3 value = relevoSquare || ab.y == 0 ? relevoCoarse(ab) : relevoFine(ab);
  if (ab.x == RELEVO_SEGMENTS)
  {
    value.x = relevoCorners.y;
  }
  return value;
}

vec3 relevoVertex(ivec2 ab)
{
  int sum = ab.x + ab.y;
  bool isOnLongestSide = sum == RELEVO_SEGMENTS;
  vec3 value = isOnLongestSide && relevoSquare ? relevoCoarse(ab) : relevoFine(ab);
  if (relevoMorph < 1.0 && !isOnLongestSide)
  {
    vec3 source;
    if (sum % 2 == 0)
    {
      source = relevoSource(ab);
    }
    else
    {
      precise vec3 middle =
        0.5 * (relevoSource(ab - ivec2(1, 0)) + relevoSource(ab + ivec2(1, 0)));
      source = middle;
    }
    value = isnan(source.x) ? value : relevoMix(source, value, relevoMorph);
  }
  if (sum == 0)
  {
    value.x = relevoCorners.x;
  }
  else if (ab.x == RELEVO_SEGMENTS)
  {
    value.x = relevoCorners.y;
  }
  else if (ab.y == RELEVO_SEGMENTS)
  {
    value.x = relevoCorners.z;
  }
  return value;
}
