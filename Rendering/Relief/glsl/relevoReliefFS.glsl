// The visible point of a relief at a pixel.
uniform vec4 reliefEye; // or the view direction
uniform mat4 reliefToClip;
uniform mat4 reliefToView;
uniform bvec2 reliefSides; // whether the front and the back of the surface are visible
uniform vec4 reliefFirstAndSize; // column and row of the coordinates' origin; the image's size

vec3 reliefPoint = vec3(0.0); // point of the surface, in coordinates of the tiles
bool reliefIsFront = true;

// Return how perpendicular to the surface the relief's viewer looked: 1, or less towards 0.
float reliefSquareness();

float reliefDepth()
{
  vec3 point = reliefPoint;
#ifdef RELIEF_YIELDS
  // If several reliefs show one surface, the one that saw it best must win consistently. Its offset
  // is less than half a texel. The back, which no viewer saw, is behind all fronts.
  float yielding = reliefIsFront ? 0.5 - 0.5 * reliefSquareness() : 1.0;
#ifdef RELIEF_RIM
  yielding += 0.25; // behind captured surfaces
#endif
  point += 0.45 * yielding * normalize(reliefEye.xyz - point * reliefEye.w);
#endif
  vec4 position = reliefToClip * vec4(point, 1.0);
  return clamp(0.5 * position.z / position.w + 0.5, 0.0, 1.0);
}

vec4 reliefVertex()
{
  vec4 position = reliefToView * vec4(reliefPoint, 1.0);
  return position / position.w;
}

int reliefPointId()
{
  ivec2 last = ivec2(reliefFirstAndSize.zw) - 1;
  ivec2 texel = clamp(ivec2(floor(reliefPoint.xy + reliefFirstAndSize.xy + 0.5)), ivec2(0), last);
  return texel.y * int(reliefFirstAndSize.z) + texel.x;
}

int reliefCellId()
{
  ivec2 last = ivec2(reliefFirstAndSize.zw) - 2;
  ivec2 quad = clamp(ivec2(floor(reliefPoint.xy + reliefFirstAndSize.xy)), ivec2(0), last);
  return quad.y * (int(reliefFirstAndSize.z) - 1) + quad.x;
}
