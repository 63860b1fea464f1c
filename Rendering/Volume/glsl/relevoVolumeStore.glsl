// The data that projected cells store if they are not yet a colour: a sum, or an extreme with its
// depth. relevoVolumeFinishFS.glsl reads them.

#if RELEVO_EXTREME
uniform int decidingComponent;

void storeRay()
{
  if (!hasExtreme)
  {
    discard;
  }
  gl_FragData[0] = vec4(extreme);
#if RELEVO_TABLES
  gl_FragData[1] = vec4(extremeSteepness);
#endif
  gl_FragDepth = componentOf(extreme, decidingComponent);
}
#elif RELEVO_AVERAGE
void storeRay()
{
  gl_FragData[0] = seenLength * vec4(mean);
  gl_FragData[1] = vec4(seenLength);
#if RELEVO_TABLES
  gl_FragData[2] = seenLength * vec4(meanSteepness);
#endif
}
#else
void storeRay()
{
  gl_FragData[0] = sum;
}
#endif
