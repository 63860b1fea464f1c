// What light makes of a colour inside a volume, where the scalar has a gradient. GLSL and C++: the
// including side says what Real, Real2, Real3 and Real4 are (float or double). One white light;
// both sides of a surface are lit alike.
//
// B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the ACM 18, 1975,
// in the form of VTK's shaders for structured volumes.

// Diffuse and specular factor. All directions have length 1.
RELEVO_FUNCTION Real2 phongFactors(Real3 normal, Real3 toLight, Real3 toEye, Real power)
{
  Real facing = dot(normal, toLight);
  Real glance = dot(Real(2) * facing * normal - toLight, toEye);
  return Real2(
    abs(facing), facing != Real(0) && glance > Real(0) ? pow(glance, power) : Real(0));
}

// What a colour is multiplied by, and how much white is added. `material` has the factors of
// ambient, diffuse and specular light and the specular power. Without a gradient there is no side,
// and the colour stays as it is.
RELEVO_FUNCTION Real2 volumeLight(Real3 gradient, Real3 toLight, Real3 toEye, Real4 material)
{
  Real steepness = length(gradient);
  if (!(steepness > Real(0)))
  {
    return Real2(Real(1), Real(0));
  }
  Real2 factors = phongFactors(gradient / steepness, toLight, toEye, material.w);
  return Real2(material.x + material.y * factors.x, material.z * factors.y);
}

// A straight colour, lit.
RELEVO_FUNCTION Real3 lightenColor(Real3 color, Real3 factor, Real3 added)
{
  return min(color * factor + added, Real3(Real(1)));
}

// The same in white light.
RELEVO_FUNCTION Real3 lightenColor(Real3 color, Real2 light)
{
  return lightenColor(color, Real3(light.x), Real3(light.y));
}
