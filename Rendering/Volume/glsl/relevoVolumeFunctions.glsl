// The transfer functions: colour and extinction of scalars, in linear pieces. What the ray has
// collected so far is `collected`, premultiplied.

uniform sampler2D psiTable;

#if RELEVO_COMPONENTS == 1
#define Scalars float
#define componentOf(scalars, i) (scalars)
#else
#define Scalars vec4
#define componentOf(scalars, i) ((scalars)[i])
#endif

#define Real float
#define Real3 vec3
#define Real4 vec4

// Of short parts, as most are, by Gauss' quadrature, which is faster than the table. There depth x
// is at x / (x + 1).
float linearSegmentPsi(float front, float back)
{
  if (front + back < 2.0)
  {
    const vec3 nodes = vec3(0.1127016654, 0.5, 0.8872983346);
    const vec3 weights = vec3(5.0, 8.0, 5.0) / 18.0;
    return dot(weights, exp(-nodes * (front + 0.5 * (back - front) * nodes)));
  }
  float size = float(RELEVO_PSI_SIZE);
  vec2 at = vec2(front, back);
  at = at / (at + vec2(1.0));
  return texture(psiTable, (at * (size - 1.0) + vec2(0.5)) / size).r;
}

//RELEVO::LinearSegment

vec4 collected = vec4(0.0);

#if RELEVO_CURVES > 0
uniform samplerBuffer functionPieces; // of each three texels
uniform int curveFirst[RELEVO_CURVES]; // pieces
uniform int curveSizes[RELEVO_CURVES]; // the number of pieces less one

struct Piece
{
  int number;
  float begin;
  float end;
  float inverse; // of its size; 0 for pieces without an end
  vec4 first;
  vec4 change;
};

Piece pieces[RELEVO_CURVES];

void fetchPiece(int curve, int number)
{
  int at = 3 * (curveFirst[curve] + number);
  vec4 range = texelFetch(functionPieces, at);
  pieces[curve] = Piece(number, range.x, range.y, range.z,
    texelFetch(functionPieces, at + 1), texelFetch(functionPieces, at + 2));
}

// The piece that a scalar is in; at its end, in the one before.
void findPiece(int curve, float scalar)
{
  int low = 0;
  int high = curveSizes[curve];
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (texelFetch(functionPieces, 3 * (curveFirst[curve] + middle)).y < scalar)
    {
      low = middle + 1;
    }
    else
    {
      high = middle;
    }
  }
  fetchPiece(curve, low);
}

// The piece of the scalars from one on towards another.
void seekPiece(int curve, float from, float to)
{
  Piece piece = pieces[curve];
  bool isIn = to > from ? piece.begin <= from && from < piece.end
                        : piece.begin < from && from <= piece.end;
  if (!isIn)
  {
    findPiece(curve, from);
    if (to > from && from >= pieces[curve].end)
    {
      fetchPiece(curve, pieces[curve].number + 1);
    }
  }
}

vec4 evaluatePiece(int curve, float scalar)
{
  Piece piece = pieces[curve];
  return piece.first + clamp((scalar - piece.begin) * piece.inverse, 0.0, 1.0) * piece.change;
}

// Straight colours and extinctions at both ends of a part that no piece ends in.
void evaluateEnds(Scalars front, Scalars back, out vec4 first, out vec4 last)
{
#if RELEVO_CURVES == 1
  first = evaluatePiece(0, componentOf(front, 0));
  last = evaluatePiece(0, componentOf(back, 0));
#elif RELEVO_DEPENDENT
  // Colours have no extinction there, and opacities no colour.
  first = evaluatePiece(0, front[0]) + evaluatePiece(1, front[1]);
  last = evaluatePiece(0, back[0]) + evaluatePiece(1, back[1]);
#else
  vec4 firsts[RELEVO_CURVES];
  vec4 lasts[RELEVO_CURVES];
  first = vec4(0.0);
  last = vec4(0.0);
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    firsts[i] = evaluatePiece(i, front[i]);
    lasts[i] = evaluatePiece(i, back[i]);
    first.w += firsts[i].w;
    last.w += lasts[i].w;
  }
  // Where there is no extinction, colours mix as next to there.
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    float shareFirst = first.w > 0.0 ? firsts[i].w / first.w : lasts[i].w / max(last.w, 1e-37);
    float shareLast = last.w > 0.0 ? lasts[i].w / last.w : firsts[i].w / max(first.w, 1e-37);
    first.rgb += shareFirst * firsts[i].rgb;
    last.rgb += shareLast * lasts[i].rgb;
  }
#endif
}
#endif
