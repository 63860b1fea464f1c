// The stage "tag" by edges: each edge gets its own tag, or each merged point the largest measure of
// its edges.

// merged points, the lower first
layout(std430, binding = 0) readonly buffer Edges { ivec2 edges[]; };
layout(std430, binding = 1) readonly buffer Values { vec4 values[]; };
// zero if merged points are measured
layout(std430, binding = 2) buffer Measures { uint measures[]; };

uniform int relevoPerEdge;

void main()
{
  int edge = relevoElement();
  if (edge >= relevoNumberOfElements)
  {
    return;
  }
  ivec2 ends = edges[edge];
  float measure = metricEdgeMeasure(values[ends.x], values[ends.y]);
  if (relevoPerEdge != 0)
  {
    measures[edge] = floatBitsToUint(metricTag(measure));
  }
  else
  {
    atomicMax(measures[ends.x], relevoMeasureBits(measure));
    atomicMax(measures[ends.y], relevoMeasureBits(measure));
  }
}
