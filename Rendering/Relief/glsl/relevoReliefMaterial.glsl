// The colour and normal of a point of a tile.
uniform sampler2D reliefColors;
uniform sampler2D reliefNormals;
uniform mat4 reliefPlaneToView;
#ifdef RELIEF_NORMALS
uniform mat3 normalMatrix;
#endif

vec2 reliefTextureCoordinates()
{
  return (vec2(reliefTile.yz) + clamp(reliefPlace, 0.0, float(RELIEF_SIZE)) + 0.5) /
    vec2(textureSize(reliefColors, 0));
}

vec4 reliefColor()
{
  vec4 color = textureLod(reliefColors, reliefTextureCoordinates(), 0.0);
#ifdef RELIEF_RIM
  if (color.a < 0.5) // beyond the edge
  {
    discard;
  }
  color.a = 1.0;
#endif
  return color;
}

#ifdef RELIEF_NORMALS
// The encoding is that of ReliefTiles.cxx.
vec3 reliefNormalOfTexel(ivec2 quad, ivec2 offset)
{
  vec2 folded = 2.0 * texelFetch(reliefNormals, reliefTile.yz + quad + offset, 0).rg - 1.0;
  vec3 normal = vec3(folded, 1.0 - abs(folded.x) - abs(folded.y));
  vec2 signs = vec2(folded.x < 0.0 ? -1.0 : 1.0, folded.y < 0.0 ? -1.0 : 1.0);
  normal.xy = normal.z < 0.0 ? (1.0 - abs(folded.yx)) * signs : folded;
  return normalize(normal);
}
#endif

// Return the normal in view coordinates, on the visible side.
vec3 reliefNormal()
{
  ivec2 quad = clamp(ivec2(floor(reliefPlace)), 0, RELIEF_SIZE - 1);
  vec2 place = reliefPlace - vec2(quad);
#ifdef RELIEF_NORMALS
  vec3 lower = mix(reliefNormalOfTexel(quad, ivec2(0)), reliefNormalOfTexel(quad, ivec2(1, 0)),
    place.x);
  vec3 upper = mix(reliefNormalOfTexel(quad, ivec2(0, 1)), reliefNormalOfTexel(quad, ivec2(1)),
    place.x);
  vec3 normal = normalize(normalMatrix * mix(lower, upper, place.y));
  return reliefIsFront ? normal : -normal;
#else
  vec4 h = reliefCorners(quad);
  vec2 slopes = reliefSlopes(h, place);
  vec4 plane = vec4(-slopes, 1.0, dot(slopes, reliefPoint.xy) - reliefPoint.z);
  vec3 normal = normalize((reliefPlaneToView * plane).xyz);
  return reliefIsFront ? -normal : normal;
#endif
}

float reliefSquareness()
{
  ivec2 quad = clamp(ivec2(floor(reliefPlace)), 0, RELIEF_SIZE - 1);
  vec2 slopes = reliefSlopes(reliefCorners(quad), reliefPlace - vec2(quad));
  return inversesqrt(1.0 + dot(slopes, slopes));
}
