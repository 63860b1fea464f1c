#version 430
// The beginning of every compute shader, with one invocation per element of a mesh.

#define RELEVO_FUNCTION
#define RELEVO_GROUP_SIZE 256

layout(local_size_x = RELEVO_GROUP_SIZE) in;

uniform int relevoNumberOfElements;

// Groups are arranged in rows, because an axis supports at most 65535. The last invocations exceed
// the number of elements.
int relevoElement()
{
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return int(group * uint(RELEVO_GROUP_SIZE) + gl_LocalInvocationID.x);
}
