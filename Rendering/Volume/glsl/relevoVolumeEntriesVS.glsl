//VTK::System::Dec
//RELEVO::Defines
// The projected outline of each face where rays may enter: a triangle or a rectangle.

uniform samplerBuffer meshPoints;

//RELEVO::Outline
//RELEVO::Cells
//RELEVO::Starts
//RELEVO::FaceOutline

flat out int face;

void main()
{
  face = gl_VertexID / 4;
  findFace(wordsOfFace(face));
  gl_Position = placeOnScreen(getFaceCorner(gl_VertexID % 4));
}
