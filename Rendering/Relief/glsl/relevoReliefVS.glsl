// The box of a tile, or nothing of it on the sides that the eye does not see: where the eye is
// inside, on all sides.
uniform samplerBuffer reliefPlaces;
uniform int reliefTilesPerRow;
uniform int reliefLayers; // how many hits of a tile and a ray are drawn
uniform mat4 reliefToClip;
uniform vec4 reliefEye;
uniform vec4 reliefViewport;

flat out vec4 reliefPlaceVSOutput; // first column and row, least and largest height
flat out ivec4 reliefTileVSOutput; // its number, its texels in the textures, how many hits to pass

// Rays that meet a border, but for rounding, are rays of both tiles.
const float reliefMargin = 0.01;

vec4 reliefBoxPosition()
{
  int tile = gl_InstanceID / reliefLayers;
  vec4 place = texelFetch(reliefPlaces, tile);
  reliefPlaceVSOutput = place;
  reliefTileVSOutput = ivec4(tile, (tile % reliefTilesPerRow) * RELIEF_TEXELS,
    (tile / reliefTilesPerRow) * RELIEF_TEXELS, gl_InstanceID % reliefLayers);

  vec3 low = vec3(place.xy, place.z) - reliefMargin;
  vec3 high = vec3(place.xy + float(RELIEF_SIZE), place.w) + reliefMargin;
  bvec3 lowSeen = greaterThan(reliefEye.xyz - low * reliefEye.w, vec3(0.0));
  bvec3 highSeen = lessThan(reliefEye.xyz - high * reliefEye.w, vec3(0.0));
  int face = gl_VertexID / 6;
  int axis = face / 2;
  bool isHigh = face % 2 == 1;
  bool isInside = !any(lowSeen) && !any(highSeen);
  if (!isInside && !(isHigh ? highSeen : lowSeen)[axis])
  {
    return vec4(0.0, 0.0, 0.0, 1.0); // a triangle without area
  }
  int corner = gl_VertexID % 6;
  bvec2 far = bvec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner >= 4);
  bvec3 ends = axis == 0 ? bvec3(isHigh, far) : axis == 1 ? bvec3(far.x, isHigh, far.y)
                                                          : bvec3(far, isHigh);
  vec4 position = reliefToClip * vec4(mix(low, high, vec3(ends)), 1.0);

  // Wider than what OpenGL rounds positions to.
  vec4 middle = reliefToClip * vec4(0.5 * (low + high), 1.0);
  if (position.w > 0.0 && middle.w > 0.0)
  {
    vec2 outwards = (position.xy / position.w - middle.xy / middle.w) * reliefViewport.zw;
    float size = max(abs(outwards.x), abs(outwards.y));
    position.xy += size > 0.0
      ? 0.04 * position.w * outwards / (size * reliefViewport.zw) : vec2(0.0);
  }
  return position;
}
