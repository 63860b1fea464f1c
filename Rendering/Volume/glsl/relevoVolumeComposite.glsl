// Composite and additive blending, exact: a part of the ray along which the scalars are linear is
// cut wherever one of the functions bends.

#if RELEVO_ADDITIVE
vec4 sum;
#endif

void beginRay()
{
  collected = vec4(0.0);
#if RELEVO_ADDITIVE
  sum = vec4(0.0);
#endif
#if RELEVO_SURFACES
  beginSurfaces();
#endif
#if RELEVO_TABLES
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    pieceRows[i] = 0.0;
  }
#endif
#if RELEVO_CURVES > 0
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    fetchPiece(i, 0);
  }
#endif
}

void beginCollecting(Scalars front)
{
#if RELEVO_TABLES
  findRows(partSteepness);
#endif
#if RELEVO_GRADIENT_OPACITY
  findGradientOpacities();
#endif
#if RELEVO_LIT
  findLights();
#endif
#if RELEVO_SURFACES
  meetSurfaces(front);
#endif
}

// A part of the ray, from a share of it to where a function bends, or to the end: then true. The
// caller comes back for the rest, so that the rays beside it need not wait.
bool collect(Scalars front, Scalars back, float span, inout float from)
{
  float to = 1.0;
  int cutting = -1;
  if (from == 0.0)
  {
    beginCollecting(front);
  }
#if RELEVO_CURVES > 0
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    float a = setComponent(front, i);
    float b = setComponent(back, i);
    if (from == 0.0)
    {
      seekPiece(i, a, b);
    }
    float node = b > a ? pieces[i].end : pieces[i].begin;
    if (b > a ? node < b : node > b && b < a)
    {
      float share = (node - a) / (b - a);
      cutting = share < to || cutting < 0 ? i : cutting;
      to = min(to, share);
    }
  }
  to = max(to, from);
#endif
#if RELEVO_SURFACES
  float surface = findSurface(front, back, from);
  bool isSurface = surface <= to;
  to = min(to, surface);
#endif
  vec4 first;
  vec4 last;
  evaluateEnds(front, back, vec2(from, to), first, last);
#if RELEVO_ADDITIVE
  sum += linearSegmentSum(first, last, (to - from) * span);
#else
  collected = frontOverBack(collected, linearSegment(first, last, (to - from) * span));
#endif
  from = max(to, 1e-30); // 0 stands for a part that is new
#if RELEVO_SURFACES
  if (isSurface)
  {
    passSurface(front, back, to);
    return false;
  }
#endif
#if RELEVO_CURVES > 0
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    if (i == cutting)
    {
      fetchPiece(i, pieces[i].number + (setComponent(back, i) > setComponent(front, i) ? 1 : -1));
    }
  }
#endif
  return cutting < 0;
}

vec4 finishRay()
{
#if RELEVO_ADDITIVE
  return min(sum, vec4(1.0));
#else
  return collected;
#endif
}
