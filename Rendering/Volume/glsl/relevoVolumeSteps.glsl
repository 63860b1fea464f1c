// Exact composite and additive blending for the functions of one component, as in
// relevoVolumeComposite.glsl, with a start piece for each cell. At most one piece is fetched per
// step, because software renderers execute both sides of a branch.

const float ThinDepth = 3.0;
const float MinimumShare = 1.0 / 64.0; // colours hardly change within this fraction
const float StepsEnd = 0.9999; // opacity

int stepPiece; // the caller sets it

#if RELEVO_ADDITIVE
vec4 sum;
#endif

// Start from the index and the end of the piece with the lowest of the cell's scalars, and find the
// piece of the front unless the cell spans several. The segment and its gradients are set.
void beginSteps(vec2 lowest, float front, float back)
{
  stepPiece = int(lowest.x) + int(back > front ? front >= lowest.y : front > lowest.y);
#if RELEVO_GRADIENT_OPACITY
  findGradientOpacities();
#endif
#if RELEVO_LIT
  findLights();
#endif
}

void beginRay()
{
  collected = vec4(0.0);
#if RELEVO_ADDITIVE
  sum = vec4(0.0);
#endif
}

bool collect(float front, float back, float span, inout float from)
{
  fetchPiece(0, stepPiece);
  Piece piece = pieces[0];
  bool rises = back > front;
  if (from == 0.0)
  {
    // Find the piece of the front in the direction of the scalars.
    bool isAbove = rises ? front >= piece.end : front > piece.end;
    bool isBelow = rises ? front < piece.begin : front <= piece.begin;
    if (isAbove || isBelow)
    {
      stepPiece += isAbove ? 1 : -1;
      return false;
    }
  }
  float node = rises ? piece.end : piece.begin;
  bool isCut = rises ? node < back : node > back && back < front;
  float to = isCut ? max((node - front) / (back - front), from) : 1.0;
  vec4 first = evaluateSet(0, mix(front, back, from), from);
  vec4 last = evaluateSet(0, mix(front, back, to), to);
  float share = to - from;
#if RELEVO_ADDITIVE
  sum += linearSegmentSum(first, last, share * span);
  float thin = 1.0;
#else
  float depth = max(max(first.w, last.w) * share * span, 1e-30);
  float thin = clamp(ThinDepth / depth, MinimumShare, 1.0);
  to = thin < 1.0 ? from + thin * share : to;
  isCut = isCut && thin == 1.0;
  collected = frontOverBack(
    collected, linearSegment(first, mix(first, last, thin), thin * share * span));
#endif
  from = max(to, 1e-30); // 0 marks a new segment
  stepPiece += isCut ? rises ? 1 : -1 : 0;
  return (!isCut && thin == 1.0) || collected.a >= StepsEnd;
}

vec4 finishRay()
{
  return collected;
}
