//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// The face where a ray enters the first visible cell: the depth test keeps the nearest one.

//RELEVO::Ray
//RELEVO::Edges
//RELEVO::Cells
//RELEVO::Faces
//RELEVO::Border

flat in int face;

void main()
{
  initializeRay();
  Entry entry = noEntry();
  if (!enters(face, entry.depth, entry.face, entry))
  {
    discard;
  }
  gl_FragDepth = 0.5 + 0.5 * entry.depth / (1.0 + abs(entry.depth));
  gl_FragData[0] = vec4(float(face + 1), 0.0, 0.0, 0.0);
}
