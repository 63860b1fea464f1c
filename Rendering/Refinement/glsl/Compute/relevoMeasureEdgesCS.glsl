// The stage "tag" by edges: each edge's own tag, or the largest measure of the edges at a place.

layout(std430, binding = 0) readonly buffer Edges { ivec2 edges[]; }; // places, the lower first
layout(std430, binding = 1) readonly buffer Values { vec4 values[]; };
layout(std430, binding = 2) buffer Measures { uint measures[]; }; // zero where places are measured

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
