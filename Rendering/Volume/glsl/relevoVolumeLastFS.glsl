//VTK::System::Dec
//VTK::Output::Dec
// The farthest corner of the faces at a pixel: no visible cell is behind it.

flat in float farthestZ;

void main()
{
  gl_FragData[0] = vec4(farthestZ, 0.0, 0.0, 0.0);
}
