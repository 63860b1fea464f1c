//VTK::System::Dec
//VTK::Output::Dec
// What has been drawn of a volume by itself, of as many pixels or others, into the window.

uniform sampler2D projected;
uniform vec4 viewportRectangle;

void main()
{
  gl_FragData[0] = texture(projected, (gl_FragCoord.xy - viewportRectangle.xy) / viewportRectangle.zw);
}
