// The end of the stage "group": writes each face to its position. Follows relevoGroupCS.glsl.

layout(std430, binding = 0) readonly buffer Entries { uint entries[]; };
layout(std430, binding = 1) readonly buffer Ranks { uint ranks[]; };
layout(std430, binding = 2) readonly buffer Groups { RelevoGroup groups[]; };
layout(std430, binding = 3) writeonly buffer Instances { uint instances[]; };
layout(std430, binding = 4) writeonly buffer Members { uvec2 members[]; };

void main()
{
  int face = relevoElement();
  if (face >= relevoNumberOfElements || ranks[face] == RELEVO_NOT_DRAWN)
  {
    return;
  }
  uint rank = ranks[face];
  RelevoGroup group = groups[entries[face] >> 3];
  instances[group.FirstFace + rank] = uint(face) << 3 | (entries[face] & 7u);
  // The first of an instance's faces writes the range of the instance's faces.
  if (rank % group.Copies == 0u)
  {
    members[group.FirstInstance + rank / group.Copies] =
      uvec2(group.FirstFace + rank, min(group.Copies, group.NumberOfFaces - rank));
  }
}
