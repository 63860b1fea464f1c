// A vertex that OpenGL's tessellator has made of a curve.

#if RELEVO_SIDES == 1
layout(isolines, equal_spacing) in;
#else
layout(quads, equal_spacing, cw) in;
#endif

uniform ivec4 relevoGroup; // w: segments of each curve
patch in int relevoPatchCurve;

void relevoPlaceVertex()
{
  // How exact coordinates are is up to the driver.
  relevoRing = int(gl_TessCoord.x * float(relevoGroup.w + RELEVO_MORE_RINGS) + 0.5);
  relevoSide = int(gl_TessCoord.y * (RELEVO_SIDES == 2 ? 1.0 : float(RELEVO_SIDES)) + 0.5);
  relevoSide = relevoSide == RELEVO_SIDES || RELEVO_SIDES == 1 ? 0 : relevoSide;
  relevoHidden = false;
  relevoTakeCurve(relevoPatchCurve);
}
