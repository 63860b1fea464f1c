// Exact composite and additive blending: a segment of the ray with linear scalars is split at every
// node of the functions.

#if RELEVO_ADDITIVE
vec4 sum;
#endif

const float PartBegin = 1e-30; // 0 marks a new segment
const float MinimumShare = 1.0 / 64.0; // colours hardly change within this fraction

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
    pieceNumbers[i] = 0;
  }
#endif
}

void beginCollecting(Scalars front)
{
#if RELEVO_TABLES
  findRows(partSteepness);
  seekScalars(front);
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

// Find the next node of a function before the fraction `to`, and return the curve that has it, or
// -1 if there is none. A new segment may begin far from the cached piece; a split at its begin then
// moves to a nearer piece.
int findCut(Scalars front, Scalars back, float from, inout float to)
{
  int cutting = -1;
#if RELEVO_CURVES > 0
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    float a = setComponent(front, i);
    float b = setComponent(back, i);
    bool isFar = from <= PartBegin && (a > pieces[i].end || a < pieces[i].begin);
    float node = b > a ? pieces[i].end : pieces[i].begin;
    bool isCut = isFar || (b > a ? node < b : node > b && b < a);
    float share = isFar ? from : clamp((node - a) / (b - a), from, 1.0);
    cutting = isCut && (cutting < 0 || share < to) ? i : cutting;
    to = isCut ? min(to, share) : to;
  }
#endif
  return cutting;
}

#if RELEVO_CURVES > 0
// Return the next piece of a curve on the way up or down to a scalar. After a jump of scalars, it
// may be far away: the walk goes at once to the piece that would have the scalar if all pieces had
// the same size, if that is ahead.
int nextPiece(int curve, float scalar, bool rises, bool isFar)
{
  int number = pieceNumbers[curve];
#if RELEVO_DISCONTINUOUS || RELEVO_CORNER_SCALARS
  int guess = int(clamp(scalar, 0.0, 1.0) * float(curveSizes[curve]));
  bool isAhead = isFar && (rises ? guess > number : guess < number);
  return isAhead ? guess : number + (rises ? 1 : -1);
#else
  return number + (rises ? 1 : -1);
#endif
}
#endif

// Advance to the next piece of a curve.
void passCut(int curve, Scalars front, Scalars back, float from)
{
#if RELEVO_CURVES > 0
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    float a = setComponent(front, i);
    bool isFar = from <= PartBegin && (a > pieces[i].end || a < pieces[i].begin);
    bool rises = isFar ? a > pieces[i].end : setComponent(back, i) > a;
    pieceNumbers[i] = i == curve ? nextPiece(i, a, rises, isFar) : pieceNumbers[i];
  }
#endif
}

#if RELEVO_MIXED
const float LargestMix = 1.0 / 8192.0; // allowed deviation of a mixed colour from linearity

// Return the fraction of a piece along which the mixed colour of independent components, a quotient
// of linear functions, is nearly linear.
float findMixedShare(Scalars front, Scalars back, vec2 shares, vec4 first, vec4 last, float span)
{
  vec4 middle;
  vec4 same;
  evaluateEnds(front, back, vec2(mix(shares.x, shares.y, 0.5)), middle, same);
  vec3 miss = abs(middle.rgb - 0.5 * (first.rgb + last.rgb));
  float seen = max(max(miss.r, miss.g), miss.b) * min(middle.w * span, 1.0);
  return seen > LargestMix ? max(sqrt(LargestMix / seen), MinimumShare) : 1.0;
}
#endif

// Integrate a segment of the ray from the fraction `from` to the next node, to a limit of the
// optical depth, or to the end; return true at the end. The caller repeats the call, so that
// neighbouring rays need not wait. Pieces are fetched in each call, because caching them is slower
// in software renderers.
bool collect(Scalars front, Scalars back, float span, inout float from)
{
  if (from == 0.0)
  {
    beginCollecting(front);
  }
#if RELEVO_CURVES > 0
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    fetchPiece(i, pieceNumbers[i]);
  }
#endif
  float to = 1.0;
  int cutting = findCut(front, back, from, to);
#if RELEVO_SURFACES
  float surface = findSurface(front, back, from);
  bool isSurface = surface <= to;
  to = min(to, surface);
#endif
  vec4 first;
  vec4 last;
  evaluateEnds(front, back, vec2(from, to), first, last);
#if RELEVO_MIXED
  float mixed = findMixedShare(front, back, vec2(from, to), first, last, (to - from) * span);
  if (mixed < 1.0)
  {
    to = mix(from, to, mixed);
    evaluateEnds(front, back, vec2(from, to), first, last);
  }
#endif
#if RELEVO_ADDITIVE
  sum += linearSegmentSum(first, last, (to - from) * span);
#else
  float depth = max(first.w, last.w) * (to - from) * span;
  float shallow = depth > MaximumDepth ? max(MaximumDepth / depth, MinimumShare) : 1.0;
  collected = frontOverBack(
    collected, linearSegment(first, mix(first, last, shallow), shallow * (to - from) * span));
  if (shallow < 1.0)
  {
    from = mix(from, to, shallow);
    return false;
  }
#endif
#if RELEVO_MIXED
  if (mixed < 1.0)
  {
    from = max(to, PartBegin);
    return false;
  }
#endif
#if RELEVO_SURFACES
  if (isSurface)
  {
    from = max(to, PartBegin);
    passSurface(front, back, to);
    return false;
  }
#endif
  passCut(cutting, front, back, from);
  from = max(to, PartBegin);
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
