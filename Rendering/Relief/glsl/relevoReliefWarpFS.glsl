// A pixel of the relief's plane, and the point that is visible through it.
uniform sampler2D warpedHeights; // 1e30 for none
uniform sampler2D warpedColors;
uniform sampler2D warpedNormals;
// k1, k2, k3 for heights in coordinates of the tiles, and the height of the plane
uniform vec4 warpCoefficients;
in vec2 warpedPlaceVSOutput;

bool reliefIsInside = true;
vec4 warpedWeights = vec4(0.0); // weights of the texels around
ivec2 warpedTexel = ivec2(0);

void reliefCut(vec4 plane)
{
  reliefIsInside = reliefIsInside && dot(plane, vec4(reliefPoint, 1.0)) >= 0.0;
}

ivec2 warpedAt(ivec2 offset)
{
  return clamp(warpedTexel + offset, ivec2(0), textureSize(warpedHeights, 0) - 1);
}

// If several texels are on the same surface as the nearest one, they are interpolated.
bool warpedFind()
{
  warpedTexel = ivec2(floor(warpedPlaceVSOutput));
  vec2 share = warpedPlaceVSOutput - vec2(warpedTexel);
  vec4 h = vec4(texelFetch(warpedHeights, warpedAt(ivec2(0)), 0).r,
    texelFetch(warpedHeights, warpedAt(ivec2(1, 0)), 0).r,
    texelFetch(warpedHeights, warpedAt(ivec2(0, 1)), 0).r,
    texelFetch(warpedHeights, warpedAt(ivec2(1)), 0).r);
  vec2 low = share.x < 0.5 ? vec2(h.x, h.z) : vec2(h.y, h.w);
  float nearest = share.y < 0.5 ? low.x : low.y;
  vec4 weights = vec4((1.0 - share.x) * (1.0 - share.y), share.x * (1.0 - share.y),
    (1.0 - share.x) * share.y, share.x * share.y);
  weights *= vec4(lessThan(abs(h - nearest), vec4(2.0)));
  warpedWeights = weights / dot(weights, vec4(1.0));
  float delta = dot(warpedWeights, h) - warpCoefficients.w;
  reliefPoint = vec3(warpedPlaceVSOutput * (1.0 + warpCoefficients.z * delta) -
      warpCoefficients.xy * delta - reliefFirstAndSize.xy, delta + warpCoefficients.w);
  return nearest < 1e29;
}

vec4 warpedMix(sampler2D picture)
{
  return warpedWeights.x * texelFetch(picture, warpedAt(ivec2(0)), 0) +
    warpedWeights.y * texelFetch(picture, warpedAt(ivec2(1, 0)), 0) +
    warpedWeights.z * texelFetch(picture, warpedAt(ivec2(0, 1)), 0) +
    warpedWeights.w * texelFetch(picture, warpedAt(ivec2(1)), 0);
}

vec4 reliefColor()
{
  return warpedMix(warpedColors);
}
