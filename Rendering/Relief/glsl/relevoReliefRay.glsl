// A pixel's ray in a tile's coordinates: all tiles of a relief have the same ray, to the bit.
uniform vec4 reliefRayBase;
uniform vec4 reliefRayX;
uniform vec4 reliefRayY;
uniform vec4 reliefViewport; // x, y, width, height in pixels

flat in vec4 reliefPlaceVSOutput;
flat in ivec4 reliefTileVSOutput;

vec3 reliefOrigin;
vec3 reliefDirection; // of length 1, away from the eye
vec2 reliefRange;     // along the ray: what is in the tile's box and not cut off

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

vec3 reliefInverse()
{
  return 1.0 / mix(reliefDirection, vec3(1e-20), equal(reliefDirection, vec3(0.0)));
}

// Where the ray is in a tile's box.
void reliefCutBox(vec3 low, vec3 high)
{
  vec3 reciprocal = reliefInverse();
  vec3 first = (low - reliefOrigin) * reciprocal;
  vec3 second = (high - reliefOrigin) * reciprocal;
  vec3 least = min(first, second);
  vec3 most = max(first, second);
  reliefRange = vec2(max(max(least.x, least.y), least.z), min(min(most.x, most.y), most.z));
}
