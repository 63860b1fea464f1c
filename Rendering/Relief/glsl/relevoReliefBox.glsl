// A ray in coordinates of the tiles, and its segment inside a tile's box.
vec3 reliefOrigin = vec3(0.0);
vec3 reliefDirection = vec3(0.0); // of length 1, away from the eye
vec2 reliefRange = vec2(0.0);     // segment inside the tile's box that is not clipped

vec3 reliefInverse()
{
  return 1.0 / mix(reliefDirection, vec3(1e-20), equal(reliefDirection, vec3(0.0)));
}

// Intersect the ray with a tile's box.
void reliefCutBox(vec3 low, vec3 high)
{
  vec3 reciprocal = reliefInverse();
  vec3 first = (low - reliefOrigin) * reciprocal;
  vec3 second = (high - reliefOrigin) * reciprocal;
  vec3 least = min(first, second);
  vec3 most = max(first, second);
  reliefRange = vec2(max(max(least.x, least.y), least.z), min(min(most.x, most.y), most.z));
}
