// Sets the tessellation levels from the segments of a face's edges. Follows
// relevoEdgeSegments.glsl.

layout(vertices = 1) out;

uniform usamplerBuffer relevoInstances; // face << 3 | permutation code

flat in int relevoPatchMember[];
patch out int relevoPatchFace;
patch out ivec3 relevoPatchSegments; // of the sorted edges (0,1), (1,2), (0,2)
patch out int relevoPatchTurned;     // 1 for relevoIsTurned()

void main()
{
  int face = int(texelFetch(relevoInstances, relevoPatchMember[0]).r >> 3);
  ivec3 segments = min(relevoSegmentsOfFace(face), ivec3(RELEVO_MOST_SEGMENTS));
  bool turned = relevoIsTurned(face);
  relevoPatchFace = face;
  relevoPatchSegments = segments;
  relevoPatchTurned = turned ? 1 : 0;

  // Outer level i belongs to the edge where coordinate i is zero.
  vec3 levels = vec3(turned ? segments.zyx : segments.yzx);
  gl_TessLevelOuter[0] = levels.x;
  gl_TessLevelOuter[1] = levels.y;
  gl_TessLevelOuter[2] = levels.z;
  gl_TessLevelInner[0] = max(levels.x, max(levels.y, levels.z));
}
