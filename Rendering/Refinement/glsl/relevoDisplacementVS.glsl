// The inputs of relevoDisplacement.glsl.

uniform float relevoDisplacementScale;
uniform float relevoDisplacementOffset;
#ifndef RELEVO_ALONG_NORMAL
uniform vec3 relevoDisplacementDirection;
#endif
#ifdef RELEVO_SEAMS
uniform isamplerBuffer relevoSeams;
#endif

float displacementScale()
{
  return relevoDisplacementScale;
}

float displacementOffset()
{
  return relevoDisplacementOffset;
}

bool displacementAlongNormal()
{
#ifdef RELEVO_ALONG_NORMAL
  return true;
#else
  return false;
#endif
}

vec3 displacementDirection(vec3 w, vec3 unitNormal)
{
#ifdef RELEVO_ALONG_NORMAL
#if defined(RELEVO_SURFACE_DIRECTIONS)
  return unitVector(surfaceDirection(w));
#elif defined(RELEVO_DIRECTIONS)
  return unitVector(
    weightedSum(cornerDirection(0), cornerDirection(1), cornerDirection(2), w));
#else
  return unitNormal;
#endif
#else
  return relevoDisplacementDirection;
#endif
}

bool hasSeams()
{
#ifdef RELEVO_SEAMS
  return true;
#else
  return false;
#endif
}

int seamPoint(int k)
{
#ifdef RELEVO_SEAMS
  return texelFetch(relevoSeams, relevoFaceIndex * 9 + k).r;
#else
  return 0;
#endif
}

vec2 pointTextureCoordinate(int id)
{
  return vec2(relevoPointDatum(id, 0).w, relevoPointDatum(id, 2).w);
}

vec4 pointFrame(int id, int k)
{
  return relevoPointDatum(id, 1 + k);
}
