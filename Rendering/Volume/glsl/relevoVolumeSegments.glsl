// Outputs the segments of a ray inside the mesh instead of its colour, from front to back: depth at
// the begin and the end, and the values of SegmentFormat. Blend modes that do not depend on the
// order have one segment for the whole ray.

uniform int lastSegment; // index of the last segment that is needed

#if RELEVO_SEGMENTS == 1
layout(std430, binding = 0) buffer SegmentRecords
{
  uint numberOfRecords;
  uint records[]; // pixel, begin, end, values
};
uniform int maximumRecords;
#else
float lastBegin = 0.0;
float lastEnd = 0.0;
float lastValues[10];
#endif

float segmentValues[10];
int segmentCount = 0;

void packScalars(int at, Scalars scalars)
{
  for (int i = 0; i < RELEVO_WIDTH; ++i)
  {
    segmentValues[at + i] = componentOf(scalars, i);
  }
}

// Return whether there is anything to output.
bool packSegment()
{
#if RELEVO_EXTREME
  packScalars(0, extreme);
#if RELEVO_TABLES
  packScalars(RELEVO_WIDTH, extremeSteepness);
#endif
  return hasExtreme;
#elif RELEVO_AVERAGE
  packScalars(0, seenLength * mean);
  segmentValues[RELEVO_WIDTH] = seenLength;
#if RELEVO_TABLES
  packScalars(RELEVO_WIDTH + 1, seenLength * meanSteepness);
#endif
  return seenLength > 0.0;
#else
#if RELEVO_ADDITIVE
  vec4 color = sum;
#else
  vec4 color = collected;
#endif
  for (int i = 0; i < 4; ++i)
  {
    segmentValues[i] = color[i];
  }
  return color != vec4(0.0);
#endif
}

void storeSegment(float begin, float end)
{
  if (!packSegment())
  {
    return;
  }
#if RELEVO_SEGMENTS == 1
  uint record = atomicAdd(numberOfRecords, 1u);
  if (record < uint(maximumRecords))
  {
    ivec2 pixel = ivec2(gl_FragCoord.xy - viewportRectangle.xy);
    uint at = record * uint(3 + RELEVO_VALUES);
    records[at] = uint(pixel.y * int(viewportRectangle.z) + pixel.x);
    records[at + 1u] = floatBitsToUint(begin);
    records[at + 2u] = floatBitsToUint(end);
    for (int i = 0; i < RELEVO_VALUES; ++i)
    {
      records[at + 3u + uint(i)] = floatBitsToUint(segmentValues[i]);
    }
  }
#else
  lastBegin = begin;
  lastEnd = end;
  lastValues = segmentValues;
#endif
  ++segmentCount;
}

void castSegments(float zStart, float zEnd)
{
  beginWalk(zStart, zEnd);
  if (walkEnd <= walkBegin)
  {
    return;
  }
  beginRay();
  Entry entry = noEntry();
  int first;
  float firstBegin = walkBegin;
  float clear = 1.0; // transmittance of the segments so far
  int count = countEntries(first);
  for (int i = 0; i < count && walkDone < walkEnd && clear > 1.0 - Opaque &&
       segmentCount <= lastSegment; ++i)
  {
    if (!findEntry(walkEnd, i == 0 ? first : -1, entry))
    {
      break;
    }
    float begin = max(entry.depth, walkDone);
    firstBegin = i == 0 ? begin : firstBegin;
#if RELEVO_ORDERED
    collected = vec4(0.0);
    walkOpacity = 1.0 - (1.0 - Opaque) / clear;
#endif
    walkFrom(entry);
#if RELEVO_ORDERED
    storeSegment(begin, min(walkDone, walkEnd));
    clear *= 1.0 - collected.a;
#endif
  }
#if !RELEVO_ORDERED
  storeSegment(firstBegin, min(walkDone, walkEnd));
#endif
}

void outputSegments()
{
#if RELEVO_SEGMENTS == 1
  gl_FragData[0] = vec4(float(segmentCount));
#else
  if (segmentCount <= lastSegment)
  {
    discard;
  }
  gl_FragData[0] = vec4(1.0, lastBegin, lastEnd, lastValues[0]);
  gl_FragData[1] = vec4(lastValues[1], lastValues[2], lastValues[3], lastValues[4]);
  gl_FragData[2] = vec4(lastValues[5], lastValues[6], lastValues[7], lastValues[8]);
#endif
}
