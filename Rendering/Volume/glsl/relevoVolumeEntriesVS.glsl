//VTK::System::Dec
// For each border face the rectangle around it on the screen, of two triangles, a pixel wider than
// it has to be: which pixels' rays go through the face is for the fragment shader to say.

uniform samplerBuffer meshPoints;
uniform usamplerBuffer borderFaces;
uniform mat4 meshToClip;
uniform vec2 pixelSize; // in clip coordinates

flat out int face;

void main()
{
  face = gl_VertexID / 6;
  uvec4 words = texelFetch(borderFaces, face);
  vec2 low = vec2(1e30);
  vec2 high = vec2(-1e30);
  for (int i = 0; i < 3; ++i)
  {
    vec4 place = meshToClip * vec4(texelFetch(meshPoints, int(words[i])).xyz, 1.0);
    low = min(low, place.xy / place.w);
    high = max(high, place.xy / place.w);
  }
  int corner = gl_VertexID % 6;
  bool isRight = corner == 1 || corner == 2 || corner == 4;
  bool isUpper = corner == 2 || corner == 4 || corner == 5;
  gl_Position = vec4(isRight ? high.x + pixelSize.x : low.x - pixelSize.x,
    isUpper ? high.y + pixelSize.y : low.y - pixelSize.y, 0.0, 1.0);
}
