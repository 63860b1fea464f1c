// Computes the smallest and largest value of 16 x 16 texels, first of the image, then of ranges.
uniform ivec2 sourceFirst; // first of the valid texels
uniform ivec2 sourceEnd;   // one past the last

vec2 relevoRange(ivec2 texel);

vec4 relevoReduce()
{
  ivec2 corner = 16 * ivec2(gl_FragCoord.xy);
  ivec2 first = max(corner, sourceFirst);
  ivec2 last = min(corner + ivec2(16), sourceEnd);
  vec2 range = vec2(1e30, -1e30);
  for (int y = first.y; y < last.y; ++y)
  {
    for (int x = first.x; x < last.x; ++x)
    {
      vec2 other = relevoRange(ivec2(x, y));
      range = vec2(min(range.x, other.x), max(range.y, other.y));
    }
  }
  return vec4(range, 0.0, 0.0);
}
