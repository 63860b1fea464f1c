// The transfer functions: colour and extinction of scalars, in linear pieces. `collected` is the
// premultiplied colour that the ray has accumulated.

#if RELEVO_COMPONENTS == 1
#define Scalars float
#define componentOf(scalars, i) (scalars)
#else
#define Scalars vec4
#define componentOf(scalars, i) ((scalars)[i])
#endif

#define Real float
#define Real2 vec2
#define Real3 vec3
#define Real4 vec4

// A rational approximation with the right value and slopes at 0. Its error is at most 1e-4 of the
// segment's opacity up to MaximumDepth. Deeper segments must be so short that colours hardly
// change.
const float MaximumDepth = 6.0;
float linearSegmentPsi(float front, float back)
{
  float f = min(front, MaximumDepth);
  float b = min(back, MaximumDepth);
  float over = 1.0 + f * (-0.009602 + 0.005723 * f + 0.008074 * b) + b * (0.071548 + 0.004529 * b);
  float under = 1.0 +
    f * (0.323731 + f * (0.046757 + 0.003872 * f + 0.007174 * b) + b * (0.066845 + 0.002954 * b)) +
    b * (0.238215 + b * (0.019333 + 0.000146 * b));
  return over / under;
}

//RELEVO::LinearSegment

vec4 collected = vec4(0.0);

//RELEVO::Gradients

// The number of functions with colour and extinction; of two dependent components the second has
// the extinction.
#if RELEVO_CURVES > 0
#define RELEVO_SETS RELEVO_CURVES
#define setComponent(scalars, i) componentOf(scalars, RELEVO_FIRST_COMPONENT + (i))
#else
#define RELEVO_SETS 1
#define setComponent(scalars, i) ((scalars).w)
#endif

uniform samplerBuffer functionPieces; // three texels each

// Return the piece that contains x, among `size` + 1 pieces from `first` on. At the end of a piece,
// return the earlier one.
int searchPieces(int first, int size, float x)
{
  int low = 0;
  int high = size;
  while (low < high)
  {
    int middle = (low + high) / 2;
    if (texelFetch(functionPieces, 3 * (first + middle)).y < x)
    {
      low = middle + 1;
    }
    else
    {
      high = middle;
    }
  }
  return low;
}

#if RELEVO_FACTORS
float setFactors[RELEVO_SETS]; // factors of the extinctions
#endif

#if RELEVO_GRADIENT_OPACITY
uniform int gradientFirst[RELEVO_SETS]; // first pieces
uniform int gradientSizes[RELEVO_SETS]; // number of pieces minus one

void findGradientOpacities()
{
  for (int i = 0; i < RELEVO_SETS; ++i)
  {
    float steepness = setComponent(partSteepness, i);
    int piece = searchPieces(gradientFirst[i], gradientSizes[i], steepness);
    int at = 3 * (gradientFirst[i] + piece);
    vec4 range = texelFetch(functionPieces, at);
    float share = clamp((steepness - range.x) * range.z, 0.0, 1.0);
    setFactors[i] = texelFetch(functionPieces, at + 1).w +
      share * texelFetch(functionPieces, at + 2).w;
  }
}
#endif

#if RELEVO_CURVES > 0
uniform int curveFirst[RELEVO_CURVES]; // first pieces
uniform int curveSizes[RELEVO_CURVES]; // number of pieces minus one

struct Piece
{
  int number;
  float begin;
  float end;
  float inverse; // inverse of the piece's size; 0 for infinite pieces
  vec4 first;
  vec4 change;
};

Piece pieces[RELEVO_CURVES];
int pieceNumbers[RELEVO_CURVES]; // pieces near the current position of the ray

#if RELEVO_TABLES
// 2D functions: rows of pieces one after the other, which differ only in their colours. A value is
// interpolated between two rows.
// lowest row, inverse of their distance, index of the last row
uniform vec3 curveRows[RELEVO_CURVES];
float pieceRows[RELEVO_CURVES];

void findRows(Scalars steepness)
{
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    vec3 rows = curveRows[i];
    pieceRows[i] = clamp((setComponent(steepness, i) - rows.x) * rows.y, 0.0, rows.z);
  }
}

void fetchPiece(int curve, int number)
{
  int at = 3 * (curveFirst[curve] + number);
  vec4 range = texelFetch(functionPieces, at);
  float row = floor(pieceRows[curve]);
  float share = pieceRows[curve] - row;
  int size = 3 * (curveSizes[curve] + 1);
  int low = at + int(row) * size;
  int high = share > 0.0 ? low + size : low;
  pieces[curve] = Piece(number, range.x, range.y, range.z,
    mix(texelFetch(functionPieces, low + 1), texelFetch(functionPieces, high + 1), share),
    mix(texelFetch(functionPieces, low + 2), texelFetch(functionPieces, high + 2), share));
}
#else
void fetchPiece(int curve, int number)
{
  int at = 3 * (curveFirst[curve] + number);
  vec4 range = texelFetch(functionPieces, at);
  pieces[curve] = Piece(number, range.x, range.y, range.z,
    texelFetch(functionPieces, at + 1), texelFetch(functionPieces, at + 2));
}
#endif

void findPiece(int curve, float scalar)
{
  pieceNumbers[curve] = searchPieces(curveFirst[curve], curveSizes[curve], scalar);
  fetchPiece(curve, pieceNumbers[curve]);
}

// Search the pieces for scalars that may be far from the previous ones.
void seekScalars(Scalars scalars)
{
  for (int i = 0; i < RELEVO_CURVES && RELEVO_INTEGRATED != 0; ++i)
  {
    findPiece(i, setComponent(scalars, i));
  }
}

vec4 evaluatePiece(int curve, float scalar)
{
  Piece piece = pieces[curve];
  return piece.first + clamp((scalar - piece.begin) * piece.inverse, 0.0, 1.0) * piece.change;
}
#else
// Scalars are the colours: scalar = scalarLow + scalarSize * the mesh's scalar, and the extinction
// per unit distance.
uniform vec4 scalarLow;
uniform vec4 scalarSize;

void seekScalars(vec4 scalars)
{
}

vec4 getColors(vec4 scalars)
{
  return max(scalarLow + scalarSize * scalars, vec4(0.0));
}
#endif

// Return the straight colour and the extinction of one of the functions at a fraction of the
// segment.
vec4 evaluateSet(int i, Scalars scalars, float share)
{
#if RELEVO_CURVES > 0
  vec4 value = evaluatePiece(i, setComponent(scalars, i));
#else
  vec4 value = getColors(scalars);
#endif
#if RELEVO_FACTORS
  value.w *= setFactors[i];
#endif
#if RELEVO_LIT
  value.rgb = lightenSet(i, value.rgb, share);
#endif
  return value;
}

// Compute straight colours and extinctions at two fractions of a segment within a piece.
void evaluateEnds(Scalars front, Scalars back, vec2 shares, out vec4 first, out vec4 last)
{
  Scalars a = mix(front, back, shares.x);
  Scalars b = mix(front, back, shares.y);
#if RELEVO_SETS == 1
  first = evaluateSet(0, a, shares.x);
  last = evaluateSet(0, b, shares.y);
#elif RELEVO_DEPENDENT
  // Colour functions have no extinction here, and opacity functions no colour.
  first = evaluateSet(0, a, shares.x) + evaluateSet(1, a, shares.x);
  last = evaluateSet(0, b, shares.y) + evaluateSet(1, b, shares.y);
#else
  vec4 firsts[RELEVO_CURVES];
  vec4 lasts[RELEVO_CURVES];
  first = vec4(0.0);
  last = vec4(0.0);
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    firsts[i] = evaluateSet(i, a, shares.x);
    lasts[i] = evaluateSet(i, b, shares.y);
    first.w += firsts[i].w;
    last.w += lasts[i].w;
  }
  // Where there is no extinction, the mixed colour is continued from the other end.
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    float shareFirst = first.w > 0.0 ? firsts[i].w / first.w : lasts[i].w / max(last.w, 1e-37);
    float shareLast = last.w > 0.0 ? lasts[i].w / last.w : firsts[i].w / max(first.w, 1e-37);
    first.rgb += shareFirst * firsts[i].rgb;
    last.rgb += shareLast * lasts[i].rgb;
  }
#endif
}

uniform float unitDistances[RELEVO_SETS];

#if RELEVO_MAPPED
// Return the straight colour and the opacity, independently of the length.
vec4 mapScalars(Scalars scalars)
{
  for (int i = 0; i < RELEVO_SETS; ++i)
  {
#if RELEVO_CURVES > 0
    findPiece(i, setComponent(scalars, i));
#endif
    setFactors[i] = unitDistances[i];
  }
  vec4 color;
  vec4 same;
  evaluateEnds(scalars, scalars, vec2(0.0), color, same);
  return vec4(color.rgb, min(color.w, 1.0));
}
#endif
