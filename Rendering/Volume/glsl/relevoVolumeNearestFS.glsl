//VTK::System::Dec
//VTK::Output::Dec
#define RELEVO_FUNCTION
//RELEVO::Defines
// The colour of the first isosurface behind a face of an active cell, on the way through adjacent
// active cells. The depth test keeps the one of the nearest face. The shader does not change the
// depth, so that hidden faces are not shaded.

//RELEVO::Ray
//RELEVO::Edges
//RELEVO::Cells
//RELEVO::Faces
//RELEVO::Border
//RELEVO::Functions
//RELEVO::Blend
//RELEVO::Part
//RELEVO::Walk

flat in int face;

uniform sampler2D opaqueDepth;

const int MostEntries = RELEVO_FOLDED == 1 ? 4 : 1; // of a ray through one face

void main()
{
  initializeRay();
  vec2 share = (gl_FragCoord.xy - viewportRectangle.xy) / viewportRectangle.zw;
  beginWalk(0.0, texture(opaqueDepth, share).r);
  beginRay();
  Entry entry = noEntry();
  bool isEntered = enters(face, entry.depth, entry.face, entry);
  for (int i = 0; i < MostEntries && isEntered && collected.a == 0.0; ++i)
  {
    walkFrom(entry);
    float last = entry.depth;
    isEntered = enters(face, last, face, entry) && entry.depth > last;
  }
  if (collected.a == 0.0)
  {
    discard;
  }
  gl_FragData[0] = finishRay();
}
