// Height sampling: one source for the shaders and, through GLM, for C++.
//
// The including side provides
//   float heightTexel(ivec2 texel)  the sample at a texel inside the map
//   float validTexel(ivec2 texel)   1 where that sample has data, 0 where it holds a fill
//   ivec2 heightSize()              the number of texels
// Texel centres lie at (i + 0.5) / n; heights are bilinear between them and clamped outside.

RELEVO_FUNCTION float heightClamped(ivec2 texel)
{
  return heightTexel(clamp(texel, ivec2(0), heightSize() - ivec2(1)));
}

RELEVO_FUNCTION vec2 heightPosition(vec2 uv)
{
  return clamp(uv, vec2(0.0f), vec2(1.0f)) * vec2(heightSize()) - vec2(0.5f);
}

// Height at uv.
RELEVO_FUNCTION float heightAt(vec2 uv)
{
  vec2 position = heightPosition(uv);
  vec2 corner = floor(position);
  vec2 t = position - corner;
  ivec2 c = ivec2(corner);
  float south = mix(heightClamped(c), heightClamped(c + ivec2(1, 0)), t.x);
  float north = mix(heightClamped(c + ivec2(0, 1)), heightClamped(c + ivec2(1, 1)), t.x);
  return mix(south, north, t.y);
}

// Gradient of the heights at a texel, per unit of u and v: central differences, one-sided at the
// border.
RELEVO_FUNCTION vec2 heightTexelGradient(ivec2 texel)
{
  ivec2 last = heightSize() - ivec2(1);
  ivec2 c = clamp(texel, ivec2(0), last);
  ivec2 low = max(c - ivec2(1), ivec2(0));
  ivec2 high = min(c + ivec2(1), last);
  vec2 span = max(vec2(high - low), vec2(1.0f));
  return vec2(heightTexel(ivec2(high.x, c.y)) - heightTexel(ivec2(low.x, c.y)),
           heightTexel(ivec2(c.x, high.y)) - heightTexel(ivec2(c.x, low.y))) /
    span * vec2(heightSize());
}

// Gradient at uv, continuous: bilinear between the texels' gradients.
RELEVO_FUNCTION vec2 heightGradientAt(vec2 uv)
{
  vec2 position = heightPosition(uv);
  vec2 corner = floor(position);
  vec2 t = position - corner;
  ivec2 c = ivec2(corner);
  vec2 south = mix(heightTexelGradient(c), heightTexelGradient(c + ivec2(1, 0)), t.x);
  vec2 north =
    mix(heightTexelGradient(c + ivec2(0, 1)), heightTexelGradient(c + ivec2(1, 1)), t.x);
  return mix(south, north, t.y);
}

// Whether every sample with a weight in heightAt(uv) has data.
RELEVO_FUNCTION bool heightValid(vec2 uv)
{
  ivec2 last = heightSize() - ivec2(1);
  vec2 position = clamp(heightPosition(uv), vec2(0.0f), vec2(last));
  ivec2 low = ivec2(floor(position));
  ivec2 high = ivec2(ceil(position));
  return validTexel(low) * validTexel(ivec2(high.x, low.y)) * validTexel(ivec2(low.x, high.y)) *
    validTexel(high) > 0.0f;
}
