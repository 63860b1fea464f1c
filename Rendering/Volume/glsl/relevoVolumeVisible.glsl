// Where the ray enters the first visible cell, and a depth behind the last one.

uniform sampler2D visibleBegins; // 1 + the number of the face, or 0 if the ray meets no visible cell
uniform sampler2D visibleEnds; // z relative to zMiddle
uniform float visibleMargin; // of z, for rounding

// Shorten the walk, and set the face of the first entry. Return the number of entries, given that of
// the mesh.
int beginVisible(int count, inout int first)
{
  ivec2 at = ivec2(gl_FragCoord.xy - viewportRectangle.xy);
  int face = int(texelFetch(visibleBegins, at, 0).r) - 1;
  float z = texelFetch(visibleEnds, at, 0).r + visibleMargin;
  float weight = 1.0 + z * rayScale.y; // positive in front of the eye
  walkEnd = weight > 0.0 ? min(walkEnd, z * rayScale.x / weight) : walkEnd;
  first = numberOfBorderFaces + face;
  return face < 0 ? 0 : count;
}
