// The stage "tag" by edges, before relevoMeasureEdgesCS.glsl: computes the values of each merged
// point.

layout(std430, binding = 0) readonly buffer Points { float points[]; }; // three per point
layout(std430, binding = 1) readonly buffer Data { vec4 data[]; };
layout(std430, binding = 2) readonly buffer MergedPoints { int places[]; };
layout(std430, binding = 3) buffer Values { uint values[]; }; // four per point

uniform int relevoHasData;
uniform int relevoHasMergedPoints; // 1: each component's maximum over coincident points is used

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
  vec4 value = metricValue(x, datum);
  for (int c = 0; c < 4; ++c)
  {
    if (relevoHasMergedPoints != 0)
    {
      atomicMax(values[4 * places[point] + c], relevoMeasureBits(value[c]));
    }
    else
    {
      values[4 * point + c] = floatBitsToUint(value[c]);
    }
  }
}
