//VTK::System::Dec
//VTK::Output::Dec
// Draws a separate image of a volume into the window, at the same or another resolution.

uniform sampler2D projected;
uniform vec4 viewportRectangle;

void main()
{
  gl_FragData[0] = texture(projected, (gl_FragCoord.xy - viewportRectangle.xy) / viewportRectangle.zw);
}
