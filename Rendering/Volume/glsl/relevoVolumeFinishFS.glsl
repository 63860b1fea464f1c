//VTK::System::Dec
//VTK::Output::Dec
#define RELEVO_FUNCTION
//RELEVO::Defines
// Converts the data of all cells at a pixel to a colour: see relevoVolumeStore.glsl.

//RELEVO::Ray
//RELEVO::Functions
//RELEVO::Blend

uniform sampler2D projected;
uniform sampler2D projected1;
uniform sampler2D projected2;

#if RELEVO_EXTREME
void loadRay(ivec2 at)
{
  vec4 stored = texelFetch(projected, at, 0);
  hasExtreme = stored.x > 0.5 * RELEVO_NONE;
  extreme = Scalars(stored);
#if RELEVO_TABLES
  extremeSteepness = Scalars(texelFetch(projected1, at, 0));
#endif
}
#elif RELEVO_AVERAGE
void loadRay(ivec2 at)
{
  seenLength = texelFetch(projected1, at, 0).x;
  mean = Scalars(texelFetch(projected, at, 0)) / seenLength;
#if RELEVO_TABLES
  meanSteepness = Scalars(texelFetch(projected2, at, 0)) / seenLength;
#endif
}
#else
void loadRay(ivec2 at)
{
  sum = texelFetch(projected, at, 0);
}
#endif

void main()
{
  loadRay(ivec2(gl_FragCoord.xy - viewportRectangle.xy));
  gl_FragData[0] = finishRay();
}
