// The visible segment of a ray inside a cell.

const float Opaque = 0.999; // surfaces behind are not visible

float walkBegin = 0.0; // begin of the visible range of depths
float walkEnd = 0.0;
float walkDone; // depth up to which the ray has been processed

#if RELEVO_CLIPPED
// The normals of the planes in the mesh, and the heights of the mesh's centre above them.
uniform vec4 clippingPlanes[RELEVO_MOST_PLANES];
uniform int numberOfClippingPlanes;

void clipRay()
{
  for (int i = 0; i < numberOfClippingPlanes; ++i)
  {
    vec4 plane = clippingPlanes[i];
    float height = dot(rayOrigin, plane.xyz) + plane.w;
    float slope = dot(rayDirection, plane.xyz);
    if (slope > 0.0)
    {
      walkBegin = max(walkBegin, -height / slope);
    }
    else if (slope < 0.0)
    {
      walkEnd = min(walkEnd, -height / slope);
    }
    else if (!(height >= 0.0))
    {
      walkEnd = walkBegin;
    }
  }
}
#endif

// Set the visible range of the ray between two window depths, from 0 to 1.
void beginWalk(float zStart, float zEnd)
{
  walkBegin = depthOfZ(2.0 * zStart + zRange.x);
  walkEnd = depthOfZ(2.0 * (zEnd - 1.0) + zRange.y);
#if RELEVO_CLIPPED
  clipRay();
#endif
  walkDone = walkBegin;
}

// The current segment of the ray, and the fraction that has been integrated.
Scalars partFront;
Scalars partBack;
float partSpan;
float partFrom;
bool isPartDone;

// Begin a segment, without the part that has been processed.
void beginPart(float begin, float end, Scalars front, Scalars back)
{
  float from = max(begin, walkDone);
  float to = min(end, walkEnd);
  isPartDone = to <= from;
  float inverse = isPartDone ? 0.0 : 1.0 / (end - begin);
  partFront = from > begin ? mix(front, back, (from - begin) * inverse) : front;
  partBack = to < end ? mix(front, back, (to - begin) * inverse) : back;
  partSpan = (to - from) * worldLength;
#if RELEVO_LIT || RELEVO_SURFACES
  partDepths = vec2(from, to);
#endif
  partFrom = 0.0;
  walkDone = max(walkDone, end);
}
