//VTK::System::Dec
//RELEVO::Defines
// The outlines of faces that relevoVolumeOutlinesFS.glsl has found.

uniform sampler2D outlineBegins; // corners 0 and 1
uniform sampler2D outlineEnds; // corners 2 and 3
uniform sampler2D outlinePlanes;
uniform int cellsPerRow;

//RELEVO::Outline

flat out int face;

void main()
{
  face = gl_VertexID / 4;
  int corner = gl_VertexID % 4;
  ivec2 at = ivec2(face % cellsPerRow, face / cellsPerRow);
  vec4 two = corner < 2 ? texelFetch(outlineBegins, at, 0) : texelFetch(outlineEnds, at, 0);
  vec3 plane = texelFetch(outlinePlanes, at, 0).xyz;
  vec2 place = corner % 2 == 0 ? two.xy : two.zw;
  gl_Position = placeOnScreen(place);
  gl_Position.z = plane.x + dot(plane.yz, place);
}
