//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// Four bytes for each cell. The first one is 0 if no isovalue is in its range, or 128 + a bit for
// each face behind which no other cell has an isovalue. The others are one of its points.

uniform samplerBuffer meshPoints;
uniform usamplerBuffer tetrahedronCorners;
uniform usamplerBuffer neighbors;
uniform samplerBuffer isoValues; // as in relevoVolumeSurfaces.glsl
uniform int numberOfIsoValues;
uniform float isoSame;
uniform sampler2D cellRanges; // from relevoVolumeRangesFS.glsl
uniform int numberOfCells;
uniform int cellsPerRow;

//RELEVO::Cells

const uint Nothing = 0xffffffffu;
// Scalars are from 0 to 1. This is more than the rounding errors inside a cell.
const float IsoMargin = 1e-5;
const float Marked = 128.0;
#if RELEVO_DISCONTINUOUS
const uint SeveralCells = 5u; // as in relevoVolumeHanging.glsl
#endif

bool isActive(uint cell)
{
  vec2 range =
    texelFetch(cellRanges, ivec2(int(cell) % cellsPerRow, int(cell) / cellsPerRow), 0).rg;
  float margin = max(IsoMargin, 2.0 * isoSame);
  bool isFound = false;
  for (int i = 0; i < numberOfIsoValues && !isFound; ++i)
  {
    float value = texelFetch(isoValues, 2 * i).x;
    isFound = value >= range.x - margin && value <= range.y + margin;
  }
  return isFound;
}

// Return whether a ray that enters through a face does not come from another active cell.
bool isStart(uint neighbor)
{
#if RELEVO_DISCONTINUOUS
  return neighbor == Nothing || neighbor % 8u == SeveralCells || !isActive(neighbor / 8u);
#else
  return neighbor == Nothing || !isActive(neighbor);
#endif
}

float markFaces(uint cell)
{
  float bits = Marked;
#if RELEVO_CURVED
  if (isCurvedCell(cell))
  {
    int count = numberOfFaces(isQuadraticCell(cell));
    for (int i = 0; i < count; ++i)
    {
      bits += isStart(wordOfCell(cell, FirstBehind + i)) ? float(1 << i) : 0.0;
    }
    return bits;
  }
#endif
  uvec4 behind = texelFetch(neighbors, int(cell));
  for (int i = 0; i < 4; ++i)
  {
    bits += isStart(behind[i]) ? float(1 << i) : 0.0;
  }
  return bits;
}

vec3 placeOf(uint cell)
{
#if RELEVO_CURVED
  if (isCurvedCell(cell))
  {
    return texelFetch(meshPoints, int(wordOfCell(cell, 0))).xyz;
  }
#endif
  return texelFetch(meshPoints, int(texelFetch(tetrahedronCorners, int(cell)).x)).xyz;
}

void main()
{
  int cell = int(gl_FragCoord.y) * cellsPerRow + int(gl_FragCoord.x);
  vec4 mark = vec4(0.0);
  if (cell < numberOfCells && isActive(uint(cell)))
  {
    mark = vec4(markFaces(uint(cell)) / 255.0, vec3(0.5) + 0.5 * placeOf(uint(cell)));
  }
  gl_FragData[0] = mark;
}
