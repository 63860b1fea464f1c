//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// Four bytes for each listed cell. The first one has a bit for each face behind which no other cell
// has an isovalue in its range. The others are one of its points.

uniform samplerBuffer meshPoints;
uniform usamplerBuffer tetrahedronCorners;
uniform usamplerBuffer neighbors;
uniform usamplerBuffer activeCells; // a bit for each cell
uniform usamplerBuffer listedCells;
uniform int numberOfCells;
uniform int cellsPerRow;

//RELEVO::Cells

const uint Nothing = 0xffffffffu;
#if RELEVO_DISCONTINUOUS
const uint SeveralCells = 5u; // as in relevoVolumeHanging.glsl
#endif

bool isActive(uint cell)
{
  return ((texelFetch(activeCells, int(cell / 32u)).r >> (cell % 32u)) & 1u) != 0u;
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
  float bits = 0.0;
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
  int index = int(gl_FragCoord.y) * cellsPerRow + int(gl_FragCoord.x);
  vec4 mark = vec4(0.0);
  if (index < numberOfCells)
  {
    uint cell = texelFetch(listedCells, index).r;
    mark = vec4(markFaces(cell) / 255.0, vec3(0.5) + 0.5 * placeOf(cell));
  }
  gl_FragData[0] = mark;
}
