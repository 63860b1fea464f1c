// The second half of the stage "group": from numbers of faces to positions and draw commands. One
// work group processes all keys; each invocation has a range of keys. Follows relevoGroupCS.glsl.

// A key's pattern, as in RefinementPatternBuffer.
struct RelevoPattern
{
  uint Copies;
  uint NumberOfIndices;
  uint FirstIndex;
  uint FirstVertex;
  uint NumberOfVertices;
  uint FirstLineVertex;
  uint NumberOfLineVertices;
};

// The commands are defined by OpenGL.
struct RelevoElementsCommand
{
  uint Count;
  uint InstanceCount;
  uint FirstIndex;
  uint BaseVertex;
  uint BaseInstance;
};

struct RelevoArraysCommand
{
  uint Count;
  uint InstanceCount;
  uint First;
  uint BaseInstance;
};

layout(std430, binding = 0) readonly buffer Counts { uint counts[]; };
layout(std430, binding = 1) readonly buffer Patterns { RelevoPattern patterns[]; };
layout(std430, binding = 2) writeonly buffer Groups { RelevoGroup groups[]; };
layout(std430, binding = 3) writeonly buffer Triangles { RelevoElementsCommand triangles[]; };
// Commands for lines, followed by points and corners.
layout(std430, binding = 4) writeonly buffer Others { RelevoArraysCommand others[]; };

uniform int relevoNumberOfKeys;

shared uvec2 relevoSums[RELEVO_GROUP_SIZE]; // faces and instances of the invocations' ranges

uint relevoDivideUp(uint a, uint b)
{
  return (a + b - 1u) / b;
}

// Return the number of instances. All have about the same number of faces.
uint relevoCountInstances(int key)
{
  return relevoDivideUp(counts[key], patterns[key].Copies);
}

// Compute inclusive sums over the invocations.
void relevoAddUp(int invocation)
{
  for (int distance = 1; distance < RELEVO_GROUP_SIZE; distance *= 2)
  {
    uvec2 sum = relevoSums[invocation];
    if (invocation >= distance)
    {
      sum += relevoSums[invocation - distance];
    }
    barrier();
    relevoSums[invocation] = sum;
    barrier();
  }
}

void relevoWriteKey(int key, uvec2 place)
{
  RelevoPattern pattern = patterns[key];
  uint faces = counts[key];
  uint instances = relevoCountInstances(key);
  uint copies = instances > 0u ? relevoDivideUp(faces, instances) : 1u;
  groups[key] = RelevoGroup(place.x, faces, place.y, copies);
  triangles[key] = RelevoElementsCommand(
    copies * pattern.NumberOfIndices, instances, pattern.FirstIndex, pattern.FirstVertex, place.y);
  // Without copies, an instance is one face.
  others[key] =
    RelevoArraysCommand(pattern.NumberOfLineVertices, faces, pattern.FirstLineVertex, place.x);
  others[key + relevoNumberOfKeys] =
    RelevoArraysCommand(pattern.NumberOfVertices, faces, pattern.FirstVertex, place.x);
  others[key + 2 * relevoNumberOfKeys] =
    RelevoArraysCommand(3u, faces, pattern.FirstVertex, place.x);
}

void main()
{
  int invocation = int(gl_LocalInvocationID.x);
  int run = (relevoNumberOfKeys + RELEVO_GROUP_SIZE - 1) / RELEVO_GROUP_SIZE;
  int begin = min(invocation * run, relevoNumberOfKeys);
  int end = min(begin + run, relevoNumberOfKeys);
  uvec2 sum = uvec2(0u);
  for (int key = begin; key < end; ++key)
  {
    sum += uvec2(counts[key], relevoCountInstances(key));
  }
  relevoSums[invocation] = sum;
  barrier();
  relevoAddUp(invocation);
  uvec2 place = relevoSums[invocation] - sum;
  for (int key = begin; key < end; ++key)
  {
    relevoWriteKey(key, place);
    place += uvec2(counts[key], relevoCountInstances(key));
  }
}
