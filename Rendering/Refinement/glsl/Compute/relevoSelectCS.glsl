// The stage "select": from tags to the pattern of each face. Follows relevoLevels.glsl, which C++
// compiles, too, so that equal tags give equal levels.

layout(std430, binding = 0) readonly buffer Elements { int elements[]; };
layout(std430, binding = 1) readonly buffer Orders { uint orders[]; }; // one byte per face
layout(std430, binding = 2) readonly buffer Tags { float tags[]; };
layout(std430, binding = 3) readonly buffer Table { uint table[]; }; // (order, 01, 12, 02)
layout(std430, binding = 4) writeonly buffer Entries { uint entries[]; };
#ifdef RELEVO_MORPHING
layout(std430, binding = 5) writeonly buffer MorphTags { float morphTags[]; };
#endif

uniform int relevoTagKind; // 0: maximumLevel everywhere, 1: per point, 2: per edge
uniform int relevoElementStride; // per face its sorted corners, or its edges (0,1), (1,2), (0,2)
uniform float relevoTagOffset; // added to the tags of all edges
uniform int relevoMaximumLevel;

vec3 relevoEdgeTags(int face)
{
  int first = face * relevoElementStride;
  if (relevoTagKind == 0)
  {
    return vec3(float(relevoMaximumLevel));
  }
  float a = tags[elements[first]];
  float b = tags[elements[first + 1]];
  float c = tags[elements[first + 2]];
  return relevoTagKind == 1 ? vec3(meanTag(a, b), meanTag(b, c), meanTag(a, c)) : vec3(a, b, c);
}

void main()
{
  int face = relevoElement();
  if (face >= relevoNumberOfElements)
  {
    return;
  }
  vec3 edgeTags = relevoEdgeTags(face);
  int entry = int(orders[face >> 2] >> (8 * (face & 3)) & 0xffu);
  for (int e = 0; e < 3; ++e)
  {
    float tag = clampTag(edgeTags[e], relevoTagOffset, relevoMaximumLevel);
    entry = entry * (relevoMaximumLevel + 1) + levelOfTag(tag);
#ifdef RELEVO_MORPHING
    morphTags[3 * face + e] = morphTag(tag, relevoMaximumLevel);
#endif
  }
  entries[face] = table[entry];
}
