// Composite blending, exact: a part of the ray along which the scalars are linear is cut wherever
// one of the functions bends.

#if RELEVO_CURVES == 0
// Scalars are the colours: scalar = scalarLow + scalarSize * what the mesh has, and the extinction
// per unit distance.
uniform vec4 scalarLow;
uniform vec4 scalarSize;

void beginRay()
{
  collected = vec4(0.0);
}

bool collect(vec4 front, vec4 back, float span, inout float from)
{
  vec4 first = max(scalarLow + scalarSize * front, vec4(0.0));
  vec4 last = max(scalarLow + scalarSize * back, vec4(0.0));
  collected = frontOverBack(collected, linearSegment(first, last, span));
  return true;
}
#else
void beginRay()
{
  collected = vec4(0.0);
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    fetchPiece(i, 0);
  }
}

// A part of the ray, from a share of it to where a function bends, or to the end: then true. The
// caller comes back for the rest, so that the rays beside it need not wait.
bool collect(Scalars front, Scalars back, float span, inout float from)
{
  float to = 1.0;
  int cutting = -1;
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    float a = componentOf(front, i);
    float b = componentOf(back, i);
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
  vec4 first;
  vec4 last;
  evaluateEnds(mix(front, back, from), mix(front, back, to), first, last);
  collected = frontOverBack(collected, linearSegment(first, last, (to - from) * span));
  from = max(to, 1e-30); // 0 stands for a part that is new
  for (int i = 0; i < RELEVO_CURVES; ++i)
  {
    if (i == cutting)
    {
      fetchPiece(i, pieces[i].number + (componentOf(back, i) > componentOf(front, i) ? 1 : -1));
    }
  }
  return cutting < 0;
}
#endif

vec4 finishRay()
{
  return collected;
}
