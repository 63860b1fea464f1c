//VTK::System::Dec
//RELEVO::Defines
// The outlines of faces that relevoVolumeOutlinesFS.glsl has found: where rays may enter, or all.

uniform sampler2D outlineBegins; // corners 0 and 1
uniform sampler2D outlineEnds; // corners 2 and 3
uniform sampler2D outlinePlanes; // z of the farthest corner, and whether no ray enters
uniform int cellsPerRow;
uniform bool hasAllFaces;
uniform float depthScale; // makes z of the mesh between -1 and 1

//RELEVO::Outline

flat out int face;
flat out float farthestZ;

void main()
{
  face = gl_VertexID / 4;
  int corner = gl_VertexID % 4;
  ivec2 at = ivec2(face % cellsPerRow, face / cellsPerRow);
  vec4 two = corner < 2 ? texelFetch(outlineBegins, at, 0) : texelFetch(outlineEnds, at, 0);
  vec2 plane = texelFetch(outlinePlanes, at, 0).xy;
  farthestZ = plane.x;
  bool isDrawn = hasAllFaces || plane.y == 0.0;
  gl_Position = placeOnScreen(isDrawn ? corner % 2 == 0 ? two.xy : two.zw : Unseen);
  gl_Position.z = hasAllFaces ? depthScale * farthestZ : 0.0;
}
