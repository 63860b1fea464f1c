// A pixel's ray in coordinates of the tiles. It is bit-identical for all tiles of a relief.
uniform vec4 reliefRayBase;
uniform vec4 reliefRayX;
uniform vec4 reliefRayY;
uniform vec4 reliefViewport; // x, y, width, height in pixels

flat in vec4 reliefPlaceVSOutput;
flat in ivec4 reliefTileVSOutput;

// Compute the line through two points from its direction and moment. Distant points would lose
// precision.
void reliefFindRay()
{
  vec2 place = 2.0 * (gl_FragCoord.xy - reliefViewport.xy) / reliefViewport.zw - 1.0;
  vec4 point = reliefRayBase + place.x * reliefRayX + place.y * reliefRayY;
  vec3 direction = reliefEye.xyz * point.w - point.xyz * reliefEye.w;
  vec3 moment = cross(point.xyz, reliefEye.xyz);
  reliefOrigin = cross(direction, moment) / dot(direction, direction);
  reliefDirection = normalize(direction);
}

// Clip the ray; the positive side is kept.
void reliefCut(vec4 plane)
{
  float value = dot(plane.xyz, reliefOrigin) + plane.w;
  float slope = dot(plane.xyz, reliefDirection);
  float end = -value / slope;
  reliefRange.x = slope > 0.0 ? max(reliefRange.x, end) : reliefRange.x;
  reliefRange.y = slope < 0.0 ? min(reliefRange.y, end) : reliefRange.y;
  if (slope == 0.0 && value < 0.0)
  {
    reliefRange = vec2(1.0, -1.0);
  }
}
