// A pixel's ray in a tile's coordinates: all tiles of a relief have the same ray, to the bit.
uniform vec4 reliefRayBase;
uniform vec4 reliefRayX;
uniform vec4 reliefRayY;
uniform vec4 reliefViewport; // x, y, width, height in pixels

flat in vec4 reliefPlaceVSOutput;
flat in ivec4 reliefTileVSOutput;

// A line through two points by its direction and moment: neither may be too far away for it.
void reliefFindRay()
{
  vec2 place = 2.0 * (gl_FragCoord.xy - reliefViewport.xy) / reliefViewport.zw - 1.0;
  vec4 point = reliefRayBase + place.x * reliefRayX + place.y * reliefRayY;
  vec3 direction = reliefEye.xyz * point.w - point.xyz * reliefEye.w;
  vec3 moment = cross(point.xyz, reliefEye.xyz);
  reliefOrigin = cross(direction, moment) / dot(direction, direction);
  reliefDirection = normalize(direction);
}

// The positive side stays.
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
