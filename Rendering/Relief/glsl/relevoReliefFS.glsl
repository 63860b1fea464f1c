// What is seen at a pixel of a relief.
uniform mat4 reliefToClip;
uniform mat4 reliefToView;
uniform vec4 reliefFirstAndSize; // column and row of the coordinates' origin; the image's size

vec3 reliefPoint; // of the surface, in the tiles' coordinates
bool reliefIsFront = true;

float reliefDepth()
{
  vec4 position = reliefToClip * vec4(reliefPoint, 1.0);
  return clamp(0.5 * position.z / position.w + 0.5, 0.0, 1.0);
}

vec4 reliefVertex()
{
  vec4 position = reliefToView * vec4(reliefPoint, 1.0);
  return position / position.w;
}

int reliefPointId()
{
  ivec2 texel = ivec2(reliefPoint.xy + reliefFirstAndSize.xy + 0.5);
  return texel.y * int(reliefFirstAndSize.z) + texel.x;
}

int reliefCellId()
{
  ivec2 quad = min(ivec2(reliefPoint.xy + reliefFirstAndSize.xy), ivec2(reliefFirstAndSize.zw) - 2);
  return quad.y * (int(reliefFirstAndSize.z) - 1) + quad.x;
}
