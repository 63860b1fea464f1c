// The faces of a tile's box that the camera sees; all faces if the camera is inside the box.
uniform samplerBuffer reliefPlaces;
uniform int reliefTilesPerRow;
uniform int reliefLayers; // number of hits drawn per tile and ray
uniform mat4 reliefToClip;
uniform vec4 reliefEye;
uniform vec4 reliefViewport;

flat out vec4 reliefPlaceVSOutput; // first column and row, smallest and largest height
// index of the tile, its texels in the textures, number of hits to skip
flat out ivec4 reliefTileVSOutput;

// The margin makes rays that hit a border, up to rounding, rays of both tiles.
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
    return vec4(0.0, 0.0, 0.0, 1.0); // a degenerate triangle
  }
  int corner = gl_VertexID % 6;
  bvec2 far = bvec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner >= 4);
  bvec3 ends = axis == 0 ? bvec3(isHigh, far) : axis == 1 ? bvec3(far.x, isHigh, far.y)
                                                          : bvec3(far, isHigh);
  vec4 position = reliefToClip * vec4(mix(low, high, vec3(ends)), 1.0);

  // The box is enlarged by more than OpenGL's rounding of positions.
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
