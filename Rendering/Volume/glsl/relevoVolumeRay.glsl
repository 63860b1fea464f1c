// The ray of a pixel through the mesh, whose points lie between -1 and 1. Rays are lines: `depth`
// is where on them something is, 0 next to the mesh's middle, and grows away from the eye.

// Homogeneous coordinates in the mesh of what lies at x, y and z between near and far plane are
// rayMiddle + x rayX + y rayY + (z - zMiddle) rayZ.
uniform vec4 rayMiddle;
uniform vec4 rayX;
uniform vec4 rayY;
uniform vec4 rayZ;
uniform vec2 zRange; // of the near and the far plane, from zMiddle on
uniform vec4 viewportRectangle; // lower left corner and size in pixels
uniform mat3 meshToWorld;

vec3 rayOrigin;
vec3 rayDirection;
vec3 rayU; // across it, so that u, v and the direction are right-handed
vec3 rayV;
vec2 rayScale;     // depth is (z - zMiddle) x / (1 + (z - zMiddle) y)
float worldLength; // of a depth of 1

// The line alone: places on it are rayOrigin + depth * rayDirection.
void initializeLine()
{
  vec2 at = 2.0 * (gl_FragCoord.xy - viewportRectangle.xy) / viewportRectangle.zw - vec2(1.0);
  vec4 place = rayMiddle + at.x * rayX + at.y * rayY;
  rayOrigin = place.xyz / place.w;
  rayDirection = rayZ.xyz - rayOrigin * rayZ.w;
  rayScale = vec2(1.0, rayZ.w) / place.w;
  worldLength = length(meshToWorld * rayDirection);
}

// And what is seen along it, by depths that are lengths in the mesh.
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

// Of a z from zMiddle on.
float depthOfZ(float z)
{
  return z * rayScale.x / (1.0 + z * rayScale.y);
}

// As the ray sees a place: across it, and along.
vec3 seenAlongRay(vec3 place)
{
  vec3 from = place - rayOrigin;
  return vec3(dot(from, rayU), dot(from, rayV), dot(from, rayDirection));
}
