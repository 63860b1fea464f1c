// A ray in the tiles' coordinates, and the part of it that is in a tile's box.
vec3 reliefOrigin;
vec3 reliefDirection; // of length 1, away from the eye
vec2 reliefRange;     // along the ray: what is in the tile's box and not cut off

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
