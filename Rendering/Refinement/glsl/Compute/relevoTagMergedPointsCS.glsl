// The end of the stage "tag" for merged points: each point gets the tag of its merged point.

layout(std430, binding = 0) readonly buffer Measures { float measures[]; };
layout(std430, binding = 1) readonly buffer MergedPoints { int places[]; };
layout(std430, binding = 2) writeonly buffer Tags { float tags[]; };

uniform int relevoHasMergedPoints;

void main()
{
  int point = relevoElement();
  if (point < relevoNumberOfElements)
  {
    int place = point;
    if (relevoHasMergedPoints != 0)
    {
      place = places[point];
    }
    tags[point] = metricTag(measures[place]);
  }
}
