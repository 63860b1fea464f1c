// Intersects a ray with the surface of a tile. Cells are traversed by their smallest and largest
// heights (A. Tevs, I. Ihrke, H.-P. Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable
// Dynamic Height Field Rendering", 2008), then quads. The intersection with a bilinear quad is a
// quadratic equation.
uniform samplerBuffer reliefRanges;

bool reliefMeetQuad(ivec2 quad, float start, float end)
{
  vec3 entry = reliefOrigin + start * reliefDirection;
  float exit = entry.z + (end - start) * reliefDirection.z;
  vec4 h = reliefCorners(quad);
  vec2 least = min(h.xy, h.zw);
  vec2 most = max(h.xy, h.zw);
  if (max(entry.z, exit) + reliefTolerance < min(least.x, least.y) ||
    min(entry.z, exit) - reliefTolerance > max(most.x, most.y))
  {
    return false;
  }
  vec2 place = entry.xy - reliefBox.xy - vec2(quad);
  vec2 step = reliefDirection.xy;
  vec3 slopes = vec3(h.y - h.x, h.z - h.x, h.x - h.y - h.z + h.w);
  float a = -slopes.z * step.x * step.y;
  float b = reliefDirection.z - dot(slopes.xy, step) - slopes.z * dot(place, step.yx);
  float c = entry.z - h.x - dot(slopes.xy, place) - slopes.z * place.x * place.y;
  float root = b * b - 4.0 * a * c;
  if (root < 0.0 || !reliefIsQuad(quad))
  {
    return false;
  }
  root = sqrt(root);
  float q = -0.5 * (b < 0.0 ? b - root : b + root);
  float first = c / q;
  float second = a != 0.0 ? q / a : first;
  float near = min(first, second);
  float far = max(first, second);
  if (reliefTake(near, 2.0 * a * near + b, start, end))
  {
    return true;
  }
  return far > near && reliefTake(far, 2.0 * a * far + b, start, end);
}

// Traverses the squares of a grid: where the ray leaves the current square, and which is next.
struct ReliefWalk
{
  ivec2 Square;
  vec2 Next; // distances to the next lines of columns and rows
};

ReliefWalk reliefStart(float distance, float size, int first, int count, ivec2 corner)
{
  vec2 place =
    (reliefOrigin.xy + distance * reliefDirection.xy - reliefBox.xy) / size;
  ReliefWalk walk;
  walk.Square = clamp(ivec2(floor(place)), corner, corner + count - 1);
  vec2 line = reliefBox.xy +
    size * (vec2(walk.Square) + vec2(greaterThanEqual(reliefDirection.xy, vec2(0.0))));
  walk.Next = (line - reliefOrigin.xy) * reliefInverse().xy;
  return walk;
}

bool reliefStep(inout ReliefWalk walk, float size, int count, ivec2 corner)
{
  bool alongRow = walk.Next.x < walk.Next.y;
  ivec2 sign = ivec2(reliefDirection.x < 0.0 ? -1 : 1, reliefDirection.y < 0.0 ? -1 : 1);
  vec2 width = abs(reliefInverse().xy) * size;
  walk.Square += alongRow ? ivec2(sign.x, 0) : ivec2(0, sign.y);
  walk.Next += alongRow ? vec2(width.x, 0.0) : vec2(0.0, width.y);
  ivec2 inside = walk.Square - corner;
  return all(greaterThanEqual(inside, ivec2(0))) && all(lessThan(inside, ivec2(count)));
}

bool reliefMeetCell(ivec2 cell, float start, float end)
{
  ivec2 corner = cell * RELIEF_CELL;
  ReliefWalk walk = reliefStart(start, 1.0, 0, RELIEF_CELL, corner);
  for (int i = 0; i < 2 * RELIEF_CELL; ++i)
  {
    float exit = min(min(walk.Next.x, walk.Next.y), end);
    if (reliefMeetQuad(walk.Square, start, max(exit, start)))
    {
      return true;
    }
    if (exit >= end || !reliefStep(walk, 1.0, RELIEF_CELL, corner))
    {
      return false;
    }
    start = max(exit, start);
  }
  return false;
}

bool reliefMeetTile()
{
  const int cells = RELIEF_SIZE / RELIEF_CELL;
  float start = reliefRange.x;
  ReliefWalk walk = reliefStart(start, float(RELIEF_CELL), 0, cells, ivec2(0));
  for (int i = 0; i < 2 * cells; ++i)
  {
    float exit = min(min(walk.Next.x, walk.Next.y), reliefRange.y);
    int index = (reliefTile.x * cells + walk.Square.y) * cells + walk.Square.x;
    vec2 heights = texelFetch(reliefRanges, index).rg + vec2(-reliefTolerance, reliefTolerance);
    // The segment of the ray between the cell's smallest and largest height.
    vec2 ends = (heights - reliefOrigin.z) * reliefInverse().z;
    float enter = max(min(ends.x, ends.y), start);
    float leave = min(max(ends.x, ends.y), max(exit, start));
    if (heights.x <= heights.y && enter <= leave && reliefMeetCell(walk.Square, enter, leave))
    {
      return true;
    }
    if (exit >= reliefRange.y || !reliefStep(walk, float(RELIEF_CELL), cells, ivec2(0)))
    {
      return false;
    }
    start = max(exit, start);
  }
  return false;
}
