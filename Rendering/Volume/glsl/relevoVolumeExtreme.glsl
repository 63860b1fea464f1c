// Maximum and minimum intensity: the extreme scalar, which is at an end of a segment, and its
// opacity. RELEVO_SIGN is 1 for the maximum, -1 for the minimum.

Scalars extreme = Scalars(0.0);
bool hasExtreme;
#if RELEVO_TABLES
Scalars extremeSteepness = Scalars(0.0);
#endif

void beginRay()
{
  collected = vec4(0.0);
  hasExtreme = false;
}

void addSample(Scalars scalars)
{
#if RELEVO_COMPONENTS == 1 || RELEVO_CURVES == 0 || RELEVO_DEPENDENT
  // The last of dependent components decides.
  bool isFarther = RELEVO_SIGN * componentOf(scalars, RELEVO_COMPONENTS - 1) >
    RELEVO_SIGN * componentOf(extreme, RELEVO_COMPONENTS - 1);
  extreme = isFarther ? scalars : extreme;
#if RELEVO_TABLES
  extremeSteepness = isFarther ? partSteepness : extremeSteepness;
#endif
#else
  bvec4 areFarther = greaterThan(RELEVO_SIGN * scalars, RELEVO_SIGN * extreme);
  extreme = mix(extreme, scalars, areFarther);
#if RELEVO_TABLES
  extremeSteepness = mix(extremeSteepness, partSteepness, areFarther);
#endif
#endif
}

bool collect(Scalars front, Scalars back, float span, inout float from)
{
  if (!hasExtreme)
  {
    hasExtreme = true;
    extreme = front;
#if RELEVO_TABLES
    extremeSteepness = partSteepness;
#endif
  }
  addSample(front);
  addSample(back);
  return true;
}

vec4 finishRay()
{
  if (!hasExtreme)
  {
    return vec4(0.0);
  }
#if RELEVO_TABLES
  findRows(extremeSteepness);
#endif
  vec4 color = mapScalars(extreme);
  return vec4(color.rgb * color.a, color.a);
}
