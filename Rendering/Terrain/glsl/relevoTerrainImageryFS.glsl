// The imagery at a fragment, from the tiles whose texels are about as large as the pixel. Colours are
// linear between levels, as in a mipmap, and a tile that has just been read fades in. Follows
// relevoTerrainTiles.glsl.

uniform sampler2DArray relevoImagery;
uniform ivec2 relevoImageryLevels; // the finest and the coarsest one
#ifdef RELEVO_GLOBE
uniform vec3 relevoClosing; // the column after the last, the period, and the last row, as relevoRaster
#endif

// In oblique views, a pixel covers a long part of the terrain. It is the mean of at most this many
// points.
const float relevoLargestNumberOfPoints = 8.0;

// Return the colour at a vertex of a tile in a layer, bilinear. Numbers of another raster are the
// first component, times their weight, which is the second component.
vec4 relevoImageryTexel(vec2 vertex, int layer)
{
#ifdef RELEVO_RASTER
  vec2 first = floor(vertex);
  vec2 fraction = vertex - first;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    ivec2 corner = ivec2(i & 1, i >> 1);
    float number = texelFetch(relevoImagery, ivec3(ivec2(first) + corner + ivec2(1), layer), 0).r;
    vec2 weights = mix(vec2(1.0) - fraction, fraction, vec2(corner));
    float weight = isnan(number) ? 0.0 : weights.x * weights.y;
    sum += isnan(number) ? vec4(0.0) : weight * vec4(number, 1.0, 0.0, 0.0);
  }
  return sum;
#else
  return textureLod(relevoImagery, relevoLayerPoint(vertex, layer), 0.0);
#endif
}

// Return the colour at a point (as relevoRaster) for a pixel that covers 2^detail samples per side.
vec4 relevoImageryAt(vec2 raster, float detail)
{
#ifdef RELEVO_GLOBE
  raster.x -= raster.x > relevoClosing.x ? relevoClosing.y : 0.0;
  raster.y = min(raster.y, relevoClosing.z);
#endif
  vec4 color = vec4(0.0);
  float rest = 1.0; // the weight of coarser levels
  int level = relevoLimitLevel(detail, relevoImageryLevels);
  do
  {
    vec2 vertex;
    ivec2 tile = relevoLocate(level, raster, vertex);
    float visibility;
    int layer = relevoFindTile(RelevoImagery, level, tile, visibility);
    if (layer >= 0)
    {
      float weight = rest * visibility * clamp(float(level + 1) - detail, 0.0, 1.0);
      weight = level == relevoImageryLevels.y ? rest : weight;
      color += weight * relevoImageryTexel(vertex, layer);
      rest -= weight;
    }
    ++level;
  } while (level <= relevoImageryLevels.y && rest > 0.0);
  return color;
}

// Return the colour of the fragment, which is multiplied by its alpha.
vec4 relevoImageryColor()
{
  // The axes of the ellipse that the pixel covers.
  float columns = relevoRight.x * relevoRight.x + relevoUp.x * relevoUp.x;
  float rows = relevoRight.y * relevoRight.y + relevoUp.y * relevoUp.y;
  float both = relevoRight.x * relevoRight.y + relevoUp.x * relevoUp.y;
  float mean = 0.5 * (columns + rows);
  float difference = length(vec2(0.5 * (columns - rows), both));
  float longer = sqrt(mean + difference);
  float shorter = sqrt(max(mean - difference, 0.0));
  vec2 axis = columns > rows ? vec2(mean + difference - rows, both)
                             : vec2(both, mean + difference - columns);
  float size = length(axis);
  axis = size > 0.0 ? axis / size * longer : vec2(0.0);
  float texel = exp2(float(relevoImageryLevels.x));
  float number = clamp(ceil(longer / max(shorter, texel)), 1.0, relevoLargestNumberOfPoints);
  float detail = log2(max(longer / number, 1e-15));
  vec4 color = vec4(0.0);
  float i = 0.5;
  do
  {
    color += relevoImageryAt(relevoRasterVSOutput + (i / number - 0.5) * axis, detail);
    i += 1.0;
  } while (i < number);
  return color / number;
}
