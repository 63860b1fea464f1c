// Outlines of projected cells and faces, in pixels. They are slightly enlarged, because the
// fragment shader decides which rays hit.

uniform mat4 meshToSeen; // x and y in pixels, times weight; depth along rays, as a fraction; weight
uniform vec4 viewportRectangle;

const float Margin = 0.03; // more than the rounding of rasterizers
const float SharpestCorner = 0.02; // as 1 + the cosine of the angle between normals
const vec2 Unseen = vec2(-10.0);

vec2 low = vec2(1e30);
vec2 high = vec2(-1e30);
float farthest = -1e30; // depth

void surround(vec4 seen)
{
  low = min(low, seen.xy / seen.w);
  high = max(high, seen.xy / seen.w);
  farthest = max(farthest, seen.z / seen.w);
}

vec2 getRectangleCorner(int corner, float margin)
{
  bool isRight = corner == 1 || corner == 2;
  bool isUpper = corner == 2 || corner == 3;
  return low.x > high.x ? Unseen
                        : vec2(isRight ? high.x + margin : low.x - margin,
                            isUpper ? high.y + margin : low.y - margin);
}

// Return twice the area of a triangle; it is positive for counterclockwise corners.
float windingOf(vec2 a, vec2 b, vec2 c)
{
  vec2 u = b - a;
  vec2 v = c - a;
  return u.x * v.y - u.y * v.x;
}

vec2 direct(vec2 edge)
{
  float size = length(edge);
  return size > 0.0 ? edge / size : vec2(0.0);
}

// Return a corner of an outline, moved outwards together with its edges.
vec2 widen(vec2 before, vec2 corner, vec2 after, float winding)
{
  vec2 a = direct(corner - before);
  vec2 b = direct(after - corner);
  vec2 first = vec2(a.y, -a.x);
  vec2 last = vec2(b.y, -b.x);
  float way = winding < 0.0 ? -Margin : Margin;
  return corner + (first + last) * (way / max(1.0 + dot(first, last), SharpestCorner));
}

vec4 placeOnScreen(vec2 place)
{
  return vec4(2.0 * place / viewportRectangle.zw - vec2(1.0), 0.0, 1.0);
}
