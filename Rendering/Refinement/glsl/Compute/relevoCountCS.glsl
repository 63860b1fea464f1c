// The beginning of the stage "group": counts the visible faces of each key, and computes each
// face's rank among them. Follows relevoGroupCS.glsl and relevoCulling.glsl.

// The culling data of a face, as in FaceCulling.
struct RelevoExtent
{
  vec4 Middle; // centre of its box, and the cosine of its cone of normals
  vec4 Half;   // half the sides of its box, and its extent behind the centre
  vec4 Axis;   // of the cone
};

layout(std430, binding = 0) readonly buffer Entries { uint entries[]; };
layout(std430, binding = 1) buffer Counts { uint counts[]; };
layout(std430, binding = 2) writeonly buffer Ranks { uint ranks[]; };
layout(std430, binding = 3) readonly buffer Extents { RelevoExtent extents[]; };

uniform int relevoCulled;         // 0: all faces are drawn
uniform vec4 relevoPlanes[5];
uniform vec3 relevoEye;           // or the direction towards a parallel camera
uniform int relevoParallel;
uniform int relevoHidesBackFaces; // 1: faces that face away are hidden

bool relevoIsHidden(int face)
{
  RelevoExtent extent = extents[face];
  for (int i = 0; i < 5; ++i)
  {
    if (isBoxBeyond(extent.Middle.xyz, extent.Half.xyz, relevoPlanes[i]))
    {
      return true;
    }
  }
  bool parallel = relevoParallel != 0;
  return relevoHidesBackFaces != 0 &&
    facesAway(extent.Axis.xyz, extent.Middle.w,
      parallel ? relevoEye : relevoEye - extent.Middle.xyz, parallel ? 0.0 : extent.Half.w);
}

void main()
{
  int face = relevoElement();
  if (face >= relevoNumberOfElements)
  {
    return;
  }
  bool hidden = relevoCulled != 0 && relevoIsHidden(face);
  ranks[face] = hidden ? RELEVO_NOT_DRAWN : atomicAdd(counts[entries[face] >> 3], 1u);
}
