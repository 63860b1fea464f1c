//VTK::System::Dec
//VTK::Output::Dec
#define RELEVO_FUNCTION
//RELEVO::Defines
//VTK::DepthPeeling::Dec

//RELEVO::Ray
//RELEVO::Edges
//RELEVO::Cells
//RELEVO::Faces
//RELEVO::Border
//RELEVO::Functions
//RELEVO::Blend
//RELEVO::Part
//RELEVO::Walk
//RELEVO::Visible

// VTK's dual depth peeling requests the range between two window depths by these names.
uniform vec2 in_inverseWindowSize;
const float g_opacityThreshold = Opaque;

void initializeRayCast()
{
  initializeRay();
}

vec4 castRay(float zStart, float zEnd)
{
  beginWalk(zStart, zEnd);
  beginRay();
  Entry entry = noEntry();
  int first;
  int count = countEntries(first);
#if RELEVO_VISIBLE
  count = beginVisible(count, first);
#endif
  for (int i = 0; i < count && !isWalkOver(); ++i)
  {
    if (!findEntry(walkEnd, i == 0 ? first : -1, entry))
    {
      break;
    }
    walkFrom(entry);
  }
  return finishRay();
}

//RELEVO::Segments
//RELEVO::Main
void main()
{
  //VTK::CallWorker::Impl
}
