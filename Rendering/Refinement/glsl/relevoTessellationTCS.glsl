// Tells OpenGL's tessellator into how many segments to cut the edges of a face.

layout(vertices = 1) out;

uniform usamplerBuffer relevoInstances;    // face << 3 | permutation code
uniform usamplerBuffer relevoEdgeSegments; // see EdgeSegments

in int relevoPatchMember[];
patch out int relevoPatchFace;
patch out ivec3 relevoPatchSegments; // of the sorted edges (0,1), (1,2), (0,2)
patch out int relevoPatchTurned;     // 1 where the sorted corners run against the cell's sense

void main()
{
  int face = int(texelFetch(relevoInstances, relevoPatchMember[0]).r >> 3u);
  int entry = int(texelFetch(relevoEdgeSegments, face).r);
  ivec3 segments =
    min(ivec3(entry & 255, entry >> 8 & 255, entry >> 16 & 255), ivec3(RELEVO_MOST_SEGMENTS));
  bool turned = (entry >> 24) != 0;
  relevoPatchFace = face;
  relevoPatchSegments = segments;
  relevoPatchTurned = turned ? 1 : 0;

  // Outer level i is that of the edge where coordinate i is zero.
  vec3 lacking = vec3(turned ? segments.zyx : segments.yzx);
  gl_TessLevelOuter[0] = lacking.x;
  gl_TessLevelOuter[1] = lacking.y;
  gl_TessLevelOuter[2] = lacking.z;
  gl_TessLevelInner[0] = max(lacking.x, max(lacking.y, lacking.z));
}
