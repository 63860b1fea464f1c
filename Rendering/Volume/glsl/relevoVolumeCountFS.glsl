//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// Counts the faces through which the ray enters the mesh, if they cannot all be drawn: those in
// front of the eye, and one for those behind it, because the ray may begin inside.

//RELEVO::Ray
//RELEVO::Edges
//RELEVO::Cells
//RELEVO::Faces
//RELEVO::Border

void main()
{
  initializeRay();
  Entry entry = noEntry();
  float begin = depthOfZ(zRange.x);
  float end = depthOfZ(zRange.y);
  int ahead = 0;
  int behind = 0;
  while (findEntry(end, -1, entry))
  {
    ahead += entry.depth < begin ? 0 : 1;
    behind = entry.depth < begin ? 1 : behind;
  }
  gl_FragData[0] = vec4(0.0, float(ahead + behind), 0.0, 0.0);
}
