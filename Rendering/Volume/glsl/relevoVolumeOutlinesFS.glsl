//VTK::System::Dec
//VTK::Output::Dec
#define RELEVO_PLANES 1
//RELEVO::Defines
// The outline of each face where rays may enter, and the depth of its plane. A pixel for each face
// takes less time than its four vertices would.

uniform samplerBuffer meshPoints;
uniform int numberOfCells; // number of faces
uniform int cellsPerRow;

//RELEVO::Outline
//RELEVO::Cells
//RELEVO::Starts
//RELEVO::FaceOutline

void main()
{
  int face = int(gl_FragCoord.y) * cellsPerRow + int(gl_FragCoord.x);
  if (face >= numberOfCells)
  {
    discard;
  }
  findFace(wordsOfFace(face));
#if RELEVO_VISIBLE
  // Rays may leave visible cells through faces that they do not enter.
  plane = vec3(farthest, isFaceUnseen ? 1.0 : 0.0, 0.0);
  isFaceUnseen = false;
#endif
  gl_FragData[0] = vec4(getFaceCorner(0), getFaceCorner(1));
  gl_FragData[1] = vec4(getFaceCorner(2), getFaceCorner(3));
  gl_FragData[2] = vec4(plane, 0.0);
}
