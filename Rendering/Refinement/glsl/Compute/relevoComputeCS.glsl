#version 430
// The beginning of every compute shader. One invocation for each element of a mesh.

#define RELEVO_FUNCTION
#define RELEVO_GROUP_SIZE 256

layout(local_size_x = RELEVO_GROUP_SIZE) in;

uniform int relevoNumberOfElements;

// Groups come in rows: an axis takes no more than 65535. The last ones reach beyond the elements.
int relevoElement()
{
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return int(group * uint(RELEVO_GROUP_SIZE) + gl_LocalInvocationID.x);
}
