//VTK::System::Dec
//VTK::Output::Dec
// What has been drawn of a volume by itself, into the window.

uniform sampler2D projected;
uniform vec4 viewportPlace;

void main()
{
  gl_FragData[0] = texelFetch(projected, ivec2(gl_FragCoord.xy - viewportPlace.xy), 0);
}
