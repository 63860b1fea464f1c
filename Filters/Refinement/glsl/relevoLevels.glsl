// Levels of edges from depth-tags (Lenz 2009, eqs. 3.1 to 3.3). GLSL and C++.

// Level of an edge between two points with finite tags: their mean, rounded half up, in
// [0, maximumLevel]. Symmetric to the bit. The mean is clamped before it becomes an integer, and
// the fraction is compared rather than 0.5 added, which would round 0.49999997 up.
RELEVO_FUNCTION int edgeLevel(float tagA, float tagB, int maximumLevel)
{
  float mean = clamp(0.5f * (tagA + tagB), 0.0f, float(maximumLevel));
  float whole = floor(mean);
  return int(whole) + (mean - whole < 0.5f ? 0 : 1);
}
