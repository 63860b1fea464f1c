// The part of a ray inside a cell, as far as it is seen.

const float Opaque = 0.999; // what is behind is not seen

float walkBegin; // depths between which the ray is seen
float walkEnd;
float walkDone; // up to here it has been seen

#if RELEVO_CLIPPED
// Of each the normal, in the mesh, and how high above the plane the mesh's middle is.
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

// What is seen of the ray: between two depths of the window, from 0 to 1.
void beginWalk(float zStart, float zEnd)
{
  walkBegin = depthOfZ(2.0 * zStart + zRange.x);
  walkEnd = depthOfZ(2.0 * (zEnd - 1.0) + zRange.y);
#if RELEVO_CLIPPED
  clipRay();
#endif
  walkDone = walkBegin;
}

// The part of the ray that is being looked at, and the share of it that has been collected.
Scalars partFront;
Scalars partBack;
float partSpan;
float partFrom;
bool isPartDone;

// Of a part of the ray only what has not been seen before counts.
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
