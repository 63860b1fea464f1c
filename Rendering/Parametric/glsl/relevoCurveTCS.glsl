// Sets the tessellation levels of a curve.

layout(vertices = 1) out;

uniform ivec4 relevoGroup; // w: segments of each curve
uniform usamplerBuffer relevoInstances;

flat in int relevoPatchMember[];
patch out int relevoPatchCurve;

void main()
{
  relevoPatchCurve = int(texelFetch(relevoInstances, relevoPatchMember[0]).r);
  float rings = float(relevoGroup.w + RELEVO_MORE_RINGS);
#if RELEVO_SIDES == 1
  gl_TessLevelOuter[0] = 1.0;
  gl_TessLevelOuter[1] = rings;
#else
  float sides = RELEVO_SIDES == 2 ? 1.0 : float(RELEVO_SIDES);
  gl_TessLevelOuter[0] = sides;
  gl_TessLevelOuter[1] = rings;
  gl_TessLevelOuter[2] = sides;
  gl_TessLevelOuter[3] = rings;
  gl_TessLevelInner[0] = rings;
  gl_TessLevelInner[1] = sides;
#endif
}
