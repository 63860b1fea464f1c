// Lighting of a colour inside of a volume by one white light, with the scalar gradient as a normal.
// Both sides of a surface are lit in the same way. GLSL and C++: the including file defines Real,
// Real2, Real3 and Real4 (float or double).
//
// B. T. Phong, "Illumination for Computer Generated Pictures", Communications of the ACM 18, 1975,
// in the form of VTK's shaders for structured volumes.

// Returns the diffuse and specular factors. All directions are normalized.
RELEVO_FUNCTION Real2 phongFactors(Real3 normal, Real3 toLight, Real3 toEye, Real power)
{
  Real facing = dot(normal, toLight);
  Real glance = dot(Real(2) * facing * normal - toLight, toEye);
  return Real2(
    abs(facing), facing != Real(0) && glance > Real(0) ? pow(glance, power) : Real(0));
}

// Returns the factor for the colour and the amount of white to add. `material` has the ambient,
// diffuse and specular factors and the specular power. Without a gradient, the colour is not
// changed.
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

// Lights a straight colour.
RELEVO_FUNCTION Real3 lightenColor(Real3 color, Real3 factor, Real3 added)
{
  return min(color * factor + added, Real3(Real(1)));
}

// Lights a straight colour with white light.
RELEVO_FUNCTION Real3 lightenColor(Real3 color, Real2 light)
{
  return lightenColor(color, Real3(light.x), Real3(light.y));
}
