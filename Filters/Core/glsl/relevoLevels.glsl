// Levels of edges from depth-tags (Lenz 2009, eqs. 3.1 to 3.3). GLSL and C++.

// The tag of an edge that lies in [0, maximumLevel]; `offset` moves all edges of a mesh.
RELEVO_FUNCTION float clampTag(float tag, float offset, int maximumLevel)
{
  return clamp(tag + offset, 0.0f, float(maximumLevel));
}

// The tag of an edge between two points with finite tags: their mean. Symmetric to the bit.
RELEVO_FUNCTION float meanTag(float tagA, float tagB)
{
  return 0.5f * (tagA + tagB);
}

// Level of an edge with a tag that is no less than 0: rounded half up. The fraction is compared
// rather than 0.5 added, which would round 0.49999997 up.
RELEVO_FUNCTION int levelOfTag(float tag)
{
  int whole = int(tag);
  return whole + (tag - float(whole) < 0.5f ? 0 : 1);
}

RELEVO_FUNCTION int edgeLevel(float tagA, float tagB, int maximumLevel)
{
  return levelOfTag(clampTag(meanTag(tagA, tagB), 0.0f, maximumLevel));
}

// The tag that vertices move by (relevoMorph.glsl), from one in [0, maximumLevel]. From the last
// rounding on it rises twice as fast: no level comes after maximumLevel, whose vertices must have
// arrived there.
RELEVO_FUNCTION float morphTag(float tag, int maximumLevel)
{
  return tag + max(tag - (float(maximumLevel) - 0.5f), 0.0f);
}
