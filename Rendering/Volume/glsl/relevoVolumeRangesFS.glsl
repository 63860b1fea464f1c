//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// The lowest and highest scalar of each cell.

uniform samplerBuffer meshPoints;
uniform samplerBuffer pointScalars;
uniform samplerBuffer cornerScalars;
uniform samplerBuffer cellScalars;
uniform usamplerBuffer tetrahedronCorners;
uniform int isoComponent;
uniform int numberOfCells;
uniform int cellsPerRow;

//RELEVO::Cells

float scalarOf(uint point)
{
#if RELEVO_COMPONENTS == 1
  return texelFetch(meshPoints, int(point)).w;
#else
  return texelFetch(pointScalars, int(point))[isoComponent];
#endif
}

vec4 scalarsOf(uvec4 points)
{
  return vec4(scalarOf(points.x), scalarOf(points.y), scalarOf(points.z), scalarOf(points.w));
}

float lowestOf(vec4 all)
{
  return min(min(all.x, all.y), min(all.z, all.w));
}

float highestOf(vec4 all)
{
  return max(max(all.x, all.y), max(all.z, all.w));
}

#if RELEVO_CURVED
// A quadratic tetrahedron is inside the range of its Bezier coefficients.
vec2 rangeOfCurved(uint cell)
{
  int at = 4 * (int(cell) - numberOfTetrahedra);
  vec4 first = scalarsOf(texelFetch(curvedCells, at));
  vec4 last = scalarsOf(texelFetch(curvedCells, at + 1));
#if RELEVO_QUADRATIC
  if (isQuadraticCell(cell))
  {
    vec2 rest = vec2(scalarOf(wordOfCell(cell, 8)), scalarOf(wordOfCell(cell, 9)));
    // on the edges 01, 12, 20, 03, 13 and 23
    last = 2.0 * last - 0.5 * (first.xyzx + first.yzxw);
    rest = 2.0 * rest - 0.5 * (first.yz + first.ww);
    first = vec4(min(lowestOf(first), min(rest.x, rest.y)), first.yz,
      max(highestOf(first), max(rest.x, rest.y)));
  }
#endif
  return vec2(min(lowestOf(first), lowestOf(last)), max(highestOf(first), highestOf(last)));
}
#endif

#if RELEVO_CELL_SCALARS
vec2 rangeOf(uint cell)
{
#if RELEVO_COMPONENTS == 1
  return vec2(texelFetch(cellScalars, int(cell)).r);
#else
  return vec2(texelFetch(cellScalars, int(cell))[isoComponent]);
#endif
}
#else
vec2 rangeOf(uint cell)
{
#if RELEVO_CURVED
  if (isCurvedCell(cell))
  {
    return rangeOfCurved(cell);
  }
#endif
#if RELEVO_CORNER_SCALARS && RELEVO_COMPONENTS == 1
  vec4 all = texelFetch(cornerScalars, int(cell));
#elif RELEVO_CORNER_SCALARS
  vec4 all;
  for (int i = 0; i < 4; ++i)
  {
    all[i] = texelFetch(cornerScalars, 4 * int(cell) + i)[isoComponent];
  }
#else
  vec4 all = scalarsOf(texelFetch(tetrahedronCorners, int(cell)));
#endif
  return vec2(lowestOf(all), highestOf(all));
}
#endif

void main()
{
  int cell = int(gl_FragCoord.y) * cellsPerRow + int(gl_FragCoord.x);
  vec2 range = cell < numberOfCells ? rangeOf(uint(cell)) : vec2(0.0);
  gl_FragData[0] = vec4(range, 0.0, 0.0);
}
