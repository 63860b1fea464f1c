// Contrast of line integral convolution, in an image or on a surface. GLSL and C++.

// The histogram stretched: `range` has the least and the largest value, `factors` the shares of the
// range that are cut off at the lower and at the upper end.
RELEVO_FUNCTION float licStretch(float value, vec2 range, vec2 factors)
{
  float width = range.y - range.x;
  float low = range.x + factors.x * width;
  float high = range.y - factors.y * width;
  return high > low ? clamp((value - low) / (high - low), 0.0f, 1.0f) : value;
}
