// Intersections of a ray with the faces of unsplit cells: the ray crosses a face if the face's
// projected border winds around it. Both cells of a face get the same result, as for tetrahedra.

const float FarOutside = 1e30;

// Return how often an edge passes from below the ray to above on its right; negative for the other
// direction.
int passesOf(Corner a, Corner b)
{
  bool rises = a.at.y <= 0.0 && b.at.y > 0.0;
  bool falls = a.at.y > 0.0 && b.at.y <= 0.0;
  // isOnLeft() tests the side of an edge in the same way.
  float area = spannedArea(a.id, a.at.xy, b.id, b.at.xy);
  return int(rises && area > 0.0) - int(falls && area < 0.0);
}

#if RELEVO_QUADRATIC
// Return the same for a parabola through a point in the middle.
int passesOfCurve(Corner a, Corner middle, Corner b)
{
  // The points are used in the order of their ids, so that all adjacent cells get the same result.
  bool isTurned = b.id < a.id;
  vec2 from = isTurned ? b.at.xy : a.at.xy;
  vec2 to = isTurned ? a.at.xy : b.at.xy;
  vec2 bend = 2.0 * from - 4.0 * middle.at.xy + 2.0 * to;
  vec2 slope = to - from - bend;
  float root = slope.y * slope.y - 4.0 * bend.y * from.y;
  float q = -0.5 * (slope.y + (slope.y < 0.0 ? -1.0 : 1.0) * sqrt(max(root, 0.0)));
  float first = from.y / q;
  float second = q / bend.y;
  bool isFirstIn = first >= 0.0 && first <= 1.0;
  bool isSecondIn = second >= 0.0 && second <= 1.0;
  bool isRight1 = from.x + first * (slope.x + first * bend.x) > 0.0;
  bool isRight2 = from.x + second * (slope.x + second * bend.x) > 0.0;
  int passes = 0;
  if ((from.y > 0.0) != (to.y > 0.0))
  {
    bool takesFirst = isFirstIn && (!isSecondIn || abs(first - 0.5) < abs(second - 0.5));
    passes = (takesFirst ? isRight1 : isRight2) ? (to.y > 0.0 ? 1 : -1) : 0;
  }
  else if (root > 0.0 && isFirstIn && isSecondIn)
  {
    // The parabola crosses twice.
    int away = from.y > 0.0 ? -1 : 1;
    bool isFirstBefore = first < second;
    passes = away * (int(isFirstBefore ? isRight1 : isRight2) -
      int(isFirstBefore ? isRight2 : isRight1));
  }
  return isTurned ? -passes : passes;
}
#endif

// Return the winding number of the border around the ray, counterclockwise: 1 if the ray leaves the
// cell, -1 if it enters.
int windingOf(Corner border[6], int size)
{
#if RELEVO_QUADRATIC
  if (size == 6)
  {
    return passesOfCurve(border[0], border[1], border[2]) +
      passesOfCurve(border[2], border[3], border[4]) +
      passesOfCurve(border[4], border[5], border[0]);
  }
#endif
  return passesOf(border[0], border[1]) + passesOf(border[1], border[2]) +
    passesOf(border[2], border[3]) + passesOf(border[3], border[0]);
}

const float CornerSize = 1e-8; // square of a length, relative to the face's size

// Intersect the ray with a bilinear face and return the parameters. `outside` is the largest
// distance of these from the centre: more than 0.5 if the ray misses the face, for example a face
// seen edge-on.
vec2 crossBilinear(vec2 p0, vec2 p1, vec2 p2, vec2 p3, out float outside)
{
  vec2 b = p1 - p0;
  vec2 c = p3 - p0;
  vec2 d = p2 - p1 - c;
  float square = cross2(c, d);
  float linear = cross2(p0, d) + cross2(c, b);
  float constant = cross2(p0, b);
  float root = sqrt(max(linear * linear - 4.0 * square * constant, 0.0));
  float q = -0.5 * (linear + (linear < 0.0 ? -root : root));
  vec2 best = vec2(0.5);
  outside = FarOutside;
  float size = dot(b, b) + dot(c, c) + dot(d, d);
  float missed = 1e4 / size;
  for (int i = 0; i < 2; ++i)
  {
    float v = i == 0 ? constant / q : q / square;
    vec2 way = b + v * d;
    float width = dot(way, way);
    // The corners of a degenerate side are one point.
    float u = width > CornerSize * size ? -dot(p0 + v * c, way) / width : 0.5;
    // At a degenerate side, rounding may give a false hit.
    vec2 miss = p0 + v * c + u * way;
    float distance = max(abs(u - 0.5), abs(v - 0.5)) + missed * dot(miss, miss);
    if (distance < outside) // false for NaN
    {
      outside = distance;
      best = vec2(u, v);
    }
  }
  return clamp(best, vec2(0.0), vec2(1.0));
}

#if RELEVO_FOLDED
// Intersections with a face that is folded in projection, such as a curved face at its silhouette.
// The ray enters and leaves through it, which the winding number does not show.
const float MinimumFold = 1e-5; // relative to the face's size: less is rounding

// Return whether a face whose control points span this rectangle may wind around the ray.
bool isAround(vec2 low, vec2 high)
{
  return max(low.x, low.y) <= 0.0 && min(high.x, high.y) >= 0.0;
}

int foldCount;
vec3 foldPlaces[4];  // parameters of a bilinear face, or barycentric coordinates of a quadratic one
float foldTurns[4]; // positive if the face's corners are counterclockwise there

bool isShare(float x)
{
  return x >= -MinimumFold && x <= 1.0 + MinimumFold;
}

// Find the intersections of a bilinear face whose border does not wind around the ray: none or two.
void foldBilinear(vec2 p0, vec2 p1, vec2 p2, vec2 p3)
{
  foldCount = 0;
  vec2 b = p1 - p0;
  vec2 c = p3 - p0;
  vec2 d = p2 - p1 - c;
  // The orientation of the face is linear in its parameters.
  vec3 turn = vec3(cross2(b, c), cross2(b, d), cross2(d, c));
  float low = turn.x + min(turn.y, 0.0) + min(turn.z, 0.0);
  float high = turn.x + max(turn.y, 0.0) + max(turn.z, 0.0);
  float least = MinimumFold * (dot(b, b) + dot(c, c) + dot(d, d));
  float square = cross2(c, d);
  float linear = cross2(p0, d) + cross2(c, b);
  float constant = cross2(p0, b);
  float root = linear * linear - 4.0 * square * constant;
  if (low > -least || high < least || !(root > 0.0))
  {
    return;
  }
  float q = -0.5 * (linear + (linear < 0.0 ? -1.0 : 1.0) * sqrt(root));
  bool areInside = true;
  for (int i = 0; i < 2; ++i)
  {
    float v = i == 0 ? constant / q : q / square;
    vec2 way = b + v * d;
    float u = -dot(p0 + v * c, way) / dot(way, way);
    areInside = areInside && isShare(u) && isShare(v);
    foldPlaces[i] = vec3(clamp(vec2(u, v), vec2(0.0), vec2(1.0)), 0.0);
    foldTurns[i] = turn.x + u * turn.y + v * turn.z;
  }
  foldCount = areInside && foldTurns[0] * foldTurns[1] < 0.0 ? 2 : 0;
}
#endif

vec3 placeOnQuadratic(Corner border[6], vec3 w)
{
  return w.x * (2.0 * w.x - 1.0) * border[0].at + w.y * (2.0 * w.y - 1.0) * border[2].at +
    w.z * (2.0 * w.z - 1.0) * border[4].at + 4.0 * w.x * w.y * border[1].at +
    4.0 * w.y * w.z * border[3].at + 4.0 * w.z * w.x * border[5].at;
}

// Return the barycentric coordinates of the ray's intersection with a quadratic face, by Newton's
// method.
vec3 crossQuadraticFace(Corner border[6])
{
  vec3 areas = vec3(cross2(border[2].at.xy, border[4].at.xy),
    cross2(border[4].at.xy, border[0].at.xy), cross2(border[0].at.xy, border[2].at.xy));
  float sum = areas.x + areas.y + areas.z;
  vec3 w = sum != 0.0 ? clamp(areas / sum, vec3(0.0), vec3(1.0)) : vec3(1.0 / 3.0);
  w /= w.x + w.y + w.z;
  for (int i = 0; i < 5; ++i)
  {
    vec2 miss = placeOnQuadratic(border, w).xy;
    // The differences are exact, because the face is quadratic.
    const float h = 0.25;
    vec2 du = (placeOnQuadratic(border, w + h * vec3(-1.0, 1.0, 0.0)) -
      placeOnQuadratic(border, w - h * vec3(-1.0, 1.0, 0.0))).xy / (2.0 * h);
    vec2 dv = (placeOnQuadratic(border, w + h * vec3(-1.0, 0.0, 1.0)) -
      placeOnQuadratic(border, w - h * vec3(-1.0, 0.0, 1.0))).xy / (2.0 * h);
    float area = cross2(du, dv);
    if (area == 0.0)
    {
      break;
    }
    float u = -cross2(miss, dv) / area;
    float v = -cross2(du, miss) / area;
    vec3 next = w + vec3(-u - v, u, v);
    if (!(abs(next.x) + abs(next.y) + abs(next.z) < 4.0))
    {
      break;
    }
    w = next;
  }
  w = clamp(w, vec3(0.0), vec3(1.0));
  return w / (w.x + w.y + w.z);
}

#if RELEVO_FOLDED && RELEVO_QUADRATIC
// Find the intersections of a quadratic face by Newton's method from start points all over it. The
// result is all intersections or none: their orientations must add up to the winding number of the
// border.
void foldQuadratic(Corner border[6], int winding)
{
  foldCount = 0;
  vec2 a = border[0].at.xy;
  vec2 b = border[2].at.xy;
  vec2 c = border[4].at.xy;
  vec2 ab = 2.0 * border[1].at.xy - 0.5 * (a + b);
  vec2 bc = 2.0 * border[3].at.xy - 0.5 * (b + c);
  vec2 ca = 2.0 * border[5].at.xy - 0.5 * (c + a);
  if (!isAround(min(min(min(a, b), c), min(min(ab, bc), ca)),
        max(max(max(a, b), c), max(max(ab, bc), ca))))
  {
    return;
  }
  c = border[0].at.xy;
  vec2 cu = 4.0 * border[1].at.xy - 3.0 * c - border[2].at.xy;
  vec2 cv = 4.0 * border[5].at.xy - 3.0 * c - border[4].at.xy;
  vec2 cuu = 2.0 * (c + border[2].at.xy) - 4.0 * border[1].at.xy;
  vec2 cvv = 2.0 * (c + border[4].at.xy) - 4.0 * border[5].at.xy;
  vec2 cuv = 4.0 * (c + border[3].at.xy - border[1].at.xy - border[5].at.xy);
#define turnAt(u, v) cross2(cu + 2.0 * (u) * cuu + (v) * cuv, cv + (u) * cuv + 2.0 * (v) * cvv)
  vec3 ends = vec3(turnAt(0.0, 0.0), turnAt(1.0, 0.0), turnAt(0.0, 1.0));
  vec3 middles = 2.0 * vec3(turnAt(0.5, 0.0), turnAt(0.5, 0.5), turnAt(0.0, 0.5)) -
    0.5 * (ends + ends.yzx);
  vec3 low = min(ends, middles);
  vec3 high = max(ends, middles);
  float least = MinimumFold * (dot(cu, cu) + dot(cv, cv) + dot(cuu, cuu) + dot(cvv, cvv));
  if (min(min(low.x, low.y), low.z) > -least || max(max(high.x, high.y), high.z) < least)
  {
    return;
  }
  int sum = 0;
  for (int start = 0; start < 16 && foldCount < 4; ++start)
  {
    vec2 at = (vec2(float(start % 4), float(start / 4)) + vec2(0.45, 0.4)) / 4.0;
    at = at.x + at.y > 1.0 ? vec2(1.0) - at : at;
    float size = 1.0;
    for (int i = 0; i < 8 && size > 1e-4 && size < 4.0; ++i)
    {
      vec2 du = cu + 2.0 * at.x * cuu + at.y * cuv;
      vec2 dv = cv + at.x * cuv + 2.0 * at.y * cvv;
      vec2 miss = c + at.x * (cu + at.x * cuu + at.y * cuv) + at.y * (cv + at.y * cvv);
      vec2 move = vec2(-cross2(miss, dv), -cross2(du, miss)) / cross2(du, dv);
      at += move;
      size = abs(move.x) + abs(move.y);
    }
    float turn = turnAt(at.x, at.y);
    bool isNew = size <= 1e-4 && isShare(at.x) && isShare(at.y) && isShare(at.x + at.y);
    for (int i = 0; i < foldCount; ++i)
    {
      vec2 apart = abs(foldPlaces[i].yz - at);
      isNew = isNew && (apart.x + apart.y > 1e-2 || turn * foldTurns[i] < 0.0);
    }
    if (isNew)
    {
      foldPlaces[foldCount] = clamp(vec3(1.0 - at.x - at.y, at), vec3(0.0), vec3(1.0));
      foldTurns[foldCount] = turn;
      sum += turn > 0.0 ? 1 : -1;
      ++foldCount;
    }
  }
#undef turnAt
  foldCount = sum == winding ? foldCount : 0;
}
#endif

// Return the cell's parameters at a point of a face.
vec3 parametersOnFace(bool isQuadratic, int face, vec3 at)
{
  // Faces are 0 1 3, 1 2 3, 2 0 3 and 0 2 1.
  vec3 quadratic = face == 0 ? vec3(at.y, 0.0, at.z)
    : face == 1              ? at
    : face == 2              ? vec3(0.0, at.x, at.z)
                             : vec3(at.z, at.y, 0.0);
  vec3 hexahedron = face == 0 ? vec3(0.0, at.y, at.x)
    : face == 1               ? vec3(1.0, at.x, at.y)
    : face == 2               ? vec3(at.x, 0.0, at.y)
    : face == 3               ? vec3(at.y, 1.0, at.x)
    : face == 4               ? vec3(at.y, at.x, 0.0)
                              : vec3(at.x, at.y, 1.0);
  return isQuadratic ? quadratic : hexahedron;
}

float depthOnFace(bool isQuadratic, Corner border[6], vec3 at)
{
  return isQuadratic
    ? placeOnQuadratic(border, at).z
    : mix(mix(border[0].at.z, border[1].at.z, at.x), mix(border[3].at.z, border[2].at.z, at.x),
        at.y);
}

// Intersect the ray with a face: return the depth, and set the cell's parameters there.
float crossFace(bool isQuadratic, int face, Corner border[6], out vec3 parameters)
{
  float outside;
  vec3 at = isQuadratic
    ? crossQuadraticFace(border)
    : vec3(crossBilinear(
             border[0].at.xy, border[1].at.xy, border[2].at.xy, border[3].at.xy, outside), 0.0);
  parameters = parametersOnFace(isQuadratic, face, at);
  return depthOnFace(isQuadratic, border, at);
}
