// The volume rendering integral over a segment of a ray with linear colour and extinction. GLSL and
// C++: the including file defines Real, Real3 and Real4 (float or double) and linearSegmentPsi().
// Colours are straight, results are premultiplied.
//
// K. Moreland, E. Angel, "A Fast High Accuracy Volume Renderer for Unstructured Data", IEEE
// Symposium on Volume Visualization and Graphics 2004: I = I0 zeta + Cb (psi - zeta) + Cf (1 -
// psi).

// `front` and `back` are red, green, blue and extinction per length.
RELEVO_FUNCTION Real4 linearSegment(Real4 front, Real4 back, Real span)
{
  Real zeta = exp(-(front.w + back.w) * span / Real(2));
  Real psi = linearSegmentPsi(front.w * span, back.w * span);
  return Real4(
    Real3(front) * (Real(1) - psi) + Real3(back) * (psi - zeta), Real(1) - zeta);
}

// Composites premultiplied colours.
RELEVO_FUNCTION Real4 frontOverBack(Real4 front, Real4 back)
{
  return front + (Real(1) - front.w) * back;
}

// Returns the integrals of colour times extinction (quadratic) and of extinction (linear).
RELEVO_FUNCTION Real4 linearSegmentSum(Real4 front, Real4 back, Real span)
{
  Real3 first = Real3(front) * (Real(2) * front.w + back.w);
  Real3 last = Real3(back) * (front.w + Real(2) * back.w);
  return Real4((first + last) / Real(6), (front.w + back.w) / Real(2)) * span;
}
