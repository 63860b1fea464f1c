// A vertex that OpenGL's tessellator has generated on a curve.

#if RELEVO_SIDES == 1
layout(isolines, equal_spacing) in;
#else
layout(quads, equal_spacing, cw) in;
#endif

uniform ivec4 relevoGroup; // w: segments of each curve
patch in int relevoPatchCurve;

void relevoPlaceVertex()
{
  // The coordinates are rounded, because OpenGL does not define their exactness.
  relevoRing = int(gl_TessCoord.x * float(relevoGroup.w + RELEVO_MORE_RINGS) + 0.5);
  relevoSide = int(gl_TessCoord.y * (RELEVO_SIDES == 2 ? 1.0 : float(RELEVO_SIDES)) + 0.5);
  relevoSide = relevoSide == RELEVO_SIDES || RELEVO_SIDES == 1 ? 0 : relevoSide;
  relevoHidden = false;
  relevoTakeCurve(relevoPatchCurve);
}
