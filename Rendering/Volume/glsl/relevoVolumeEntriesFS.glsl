//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// Accumulates over all border faces: the sum of the indices of faces through which the ray enters,
// and their number.

//RELEVO::Ray
//RELEVO::Edges
//RELEVO::Cells
//RELEVO::Faces
//RELEVO::Border

flat in int face;

void main()
{
  initializeRay();
  Entry entry = Entry(0.0, -1, 0u, Corner(0u, vec3(0.0)), Corner(0u, vec3(0.0)),
    Corner(0u, vec3(0.0)), vec3(0.0));
  if (!enters(face, -1e30, -1, entry))
  {
    discard;
  }
  float count = 1.0;
#if RELEVO_FOLDED
  // This counts entries through a folded face alone.
  Entry next = entry;
  count += enters(face, entry.depth, face, next) && entry.depth < next.depth ? 1.0 : 0.0;
#endif
  gl_FragData[0] = vec4(count * float(face), count, 0.0, 0.0);
}
