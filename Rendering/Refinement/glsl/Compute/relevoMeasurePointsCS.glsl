// The stage "tag" per point: each point gets its own tag, or the largest measure of its merged
// point.

layout(std430, binding = 0) readonly buffer Points { float points[]; }; // three per point
layout(std430, binding = 1) readonly buffer Data { vec4 data[]; };
layout(std430, binding = 2) readonly buffer MergedPoints { int places[]; };
layout(std430, binding = 3) buffer Measures { uint measures[]; }; // zero for merged points

uniform int relevoHasData;
uniform int relevoHasMergedPoints; // 1: coincident points are merged

void main()
{
  int point = relevoElement();
  if (point >= relevoNumberOfElements)
  {
    return;
  }
  vec3 x = vec3(points[3 * point], points[3 * point + 1], points[3 * point + 2]);
  vec4 datum = vec4(0.0);
  if (relevoHasData != 0)
  {
    datum = data[point];
  }
  float measure = metricPointMeasure(metricValue(x, datum));
  if (relevoHasMergedPoints != 0)
  {
    atomicMax(measures[places[point]], relevoMeasureBits(measure));
  }
  else
  {
    measures[point] = floatBitsToUint(metricTag(measure));
  }
}
