// Levels of edges from depth-tags (Lenz 2009, eqs. 3.1 to 3.3). GLSL and C++.

// The tag of an edge, limited to [0, maximumLevel]. `offset` is added to all edges of a mesh.
RELEVO_FUNCTION float clampTag(float tag, float offset, int maximumLevel)
{
  return clamp(tag + offset, 0.0f, float(maximumLevel));
}

// The tag of an edge between two points with finite tags: their mean. Bitwise symmetric.
RELEVO_FUNCTION float meanTag(float tagA, float tagB)
{
  return 0.5f * (tagA + tagB);
}

// Level of an edge with a non-negative tag, rounded half up. Adding 0.5 would round 0.49999997 up,
// so the fraction is compared.
RELEVO_FUNCTION int levelOfTag(float tag)
{
  int whole = int(tag);
  return whole + (tag - float(whole) < 0.5f ? 0 : 1);
}

RELEVO_FUNCTION int edgeLevel(float tagA, float tagB, int maximumLevel)
{
  return levelOfTag(clampTag(meanTag(tagA, tagB), 0.0f, maximumLevel));
}

// The tag for moving vertices (relevoMorph.glsl), from a tag in [0, maximumLevel]. Above
// maximumLevel - 0.5 it rises twice as fast, because vertices of the last level must reach their
// positions at maximumLevel.
RELEVO_FUNCTION float morphTag(float tag, int maximumLevel)
{
  return tag + max(tag - (float(maximumLevel) - 0.5f), 0.0f);
}
