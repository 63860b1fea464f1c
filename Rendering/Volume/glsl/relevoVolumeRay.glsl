// The ray of a pixel through the mesh, whose points are between -1 and 1. Rays are lines: `depth`
// is the position on the line, 0 next to the mesh's centre, and increases away from the eye.

// The homogeneous coordinates in the mesh of x, y and z between near and far plane are rayMiddle +
// x rayX + y rayY + (z - zMiddle) rayZ.
uniform vec4 rayMiddle;
uniform vec4 rayX;
uniform vec4 rayY;
uniform vec4 rayZ;
uniform vec2 zRange; // of the near and the far plane, relative to zMiddle
uniform vec4 viewportRectangle; // lower left corner and size in pixels
uniform mat3 meshToWorld;

vec3 rayOrigin;
vec3 rayDirection;
vec3 rayU; // perpendicular to the ray; u, v and the direction are right-handed
vec3 rayV;
vec2 rayScale;     // depth is (z - zMiddle) x / (1 + (z - zMiddle) y)
float worldLength; // world length of a unit of depth

// Compute only the line; its positions are rayOrigin + depth * rayDirection.
void initializeLine()
{
  vec2 at = 2.0 * (gl_FragCoord.xy - viewportRectangle.xy) / viewportRectangle.zw - vec2(1.0);
  vec4 place = rayMiddle + at.x * rayX + at.y * rayY;
  rayOrigin = place.xyz / place.w;
  rayDirection = rayZ.xyz - rayOrigin * rayZ.w;
  rayScale = vec2(1.0, rayZ.w) / place.w;
  // The square of a large length is not finite.
  vec3 way = meshToWorld * rayDirection;
  float largest = max(max(abs(way.x), abs(way.y)), abs(way.z));
  worldLength = largest * length(way / largest);
}

// Compute the line, and the visible range of depths, which are lengths in the mesh.
void initializeRay()
{
  initializeLine();
  float speed = length(rayDirection);
  rayDirection /= speed;
  rayScale.x *= speed;
  worldLength /= speed;
  vec3 size = abs(rayDirection);
  vec3 axis = size.x <= size.y && size.x <= size.z ? vec3(1.0, 0.0, 0.0)
    : size.y <= size.z                             ? vec3(0.0, 1.0, 0.0)
                                                   : vec3(0.0, 0.0, 1.0);
  rayU = normalize(cross(rayDirection, axis));
  rayV = cross(rayDirection, rayU);
}

// Return the depth of a z relative to zMiddle.
float depthOfZ(float z)
{
  return z * rayScale.x / (1.0 + z * rayScale.y);
}

// Return a position in the ray's coordinates: across it and along it.
vec3 seenAlongRay(vec3 place)
{
  vec3 from = place - rayOrigin;
  return vec3(dot(from, rayU), dot(from, rayV), dot(from, rayDirection));
}
