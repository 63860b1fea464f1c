// Composites isosurfaces alone, front to back.

void beginRay()
{
  collected = vec4(0.0);
  beginSurfaces();
}

bool collect(Scalars front, Scalars back, float span, inout float from)
{
  if (from == 0.0)
  {
#if RELEVO_TABLES
    findRows(partSteepness);
#endif
    meetSurfaces(front);
  }
  float share = findSurface(front, back, from);
  if (share > 1.0)
  {
    return true;
  }
  passSurface(front, back, share);
  from = max(share, 1e-30);
  return false;
}

vec4 finishRay()
{
  return collected;
}
