// Contrast enhancement of line integral convolution, in an image or on a surface. GLSL and C++.

// Stretches the histogram. `range` has the smallest and largest value, `factors` the fractions of
// the range to cut off at both ends.
RELEVO_FUNCTION float licStretch(float value, vec2 range, vec2 factors)
{
  float width = range.y - range.x;
  float low = range.x + factors.x * width;
  float high = range.y - factors.y * width;
  return high > low ? clamp((value - low) / (high - low), 0.0f, 1.0f) : value;
}
