// Height sampling, shared by the shaders and, through GLM, C++.
//
// The including code provides
//     float heightTexel(ivec2 texel)  the sample at a texel inside the map
//     float validTexel(ivec2 texel)   1 if that sample is valid, 0 if it is missing
//     ivec2 heightSize()              the number of texels
// Texel centres are at (i + 0.5) / n. Heights are bilinear between them and clamped outside.

// Position in texels, clamped to the outermost centres.
RELEVO_FUNCTION vec2 heightPosition(vec2 uv)
{
  vec2 last = vec2(heightSize() - ivec2(1));
  return clamp(uv * vec2(heightSize()) - vec2(0.5f), vec2(0.0f), last);
}

// Height between the texels at a and a + 1, with fractions t.
RELEVO_FUNCTION float heightBetween(ivec2 a, vec2 t)
{
  ivec2 b = min(a + ivec2(1), heightSize() - ivec2(1));
  return mix(mix(heightTexel(a), heightTexel(ivec2(b.x, a.y)), t.x),
    mix(heightTexel(ivec2(a.x, b.y)), heightTexel(b), t.x), t.y);
}

// Height at uv and its gradient per unit of u and v: (height, d/du, d/dv). The gradient is bilinear
// between the texels' central differences (one-sided at the border) and therefore continuous.
RELEVO_FUNCTION vec3 heightAndGradientAt(vec2 uv)
{
  ivec2 last = heightSize() - ivec2(1);
  vec2 position = heightPosition(uv);
  ivec2 a = ivec2(floor(position));
  ivec2 b = min(a + ivec2(1), last);
  ivec2 low = max(a - ivec2(1), ivec2(0));
  ivec2 high = min(b + ivec2(1), last);
  vec2 t = position - vec2(a);

  float h00 = heightTexel(a);
  float h10 = heightTexel(ivec2(b.x, a.y));
  float h01 = heightTexel(ivec2(a.x, b.y));
  float h11 = heightTexel(b);
  vec2 spanA = max(vec2(b - low), vec2(1.0f));
  vec2 spanB = max(vec2(high - a), vec2(1.0f));
  vec2 g00 = vec2(h10 - heightTexel(ivec2(low.x, a.y)), h01 - heightTexel(ivec2(a.x, low.y))) / spanA;
  vec2 g10 = vec2((heightTexel(ivec2(high.x, a.y)) - h00) / spanB.x,
    (h11 - heightTexel(ivec2(b.x, low.y))) / spanA.y);
  vec2 g01 = vec2((h11 - heightTexel(ivec2(low.x, b.y))) / spanA.x,
    (heightTexel(ivec2(a.x, high.y)) - h00) / spanB.y);
  vec2 g11 = vec2(heightTexel(ivec2(high.x, b.y)) - h01, heightTexel(ivec2(b.x, high.y)) - h10) / spanB;

  vec2 gradient = mix(mix(g00, g10, t.x), mix(g01, g11, t.x), t.y) * vec2(heightSize());
  return vec3(mix(mix(h00, h10, t.x), mix(h01, h11, t.x), t.y), gradient.x, gradient.y);
}

// Whether every sample with a weight in the height at uv is valid.
RELEVO_FUNCTION bool heightValid(vec2 uv)
{
  vec2 position = heightPosition(uv);
  ivec2 low = ivec2(floor(position));
  ivec2 high = ivec2(ceil(position));
  return validTexel(low) * validTexel(ivec2(high.x, low.y)) * validTexel(ivec2(low.x, high.y)) *
    validTexel(high) > 0.0f;
}
