// Fur (Lenz 2009, fig. 5.14): g sin(u f pi) sin(v f pi) sin(w f pi), where g is the mean cosine of
// the angles between the corners' normals. It is 0 on the borders. The including code provides vec3
// cornerNormal(int).

const float proceduralPi = 3.14159265358979f;

RELEVO_FUNCTION float furFactor()
{
  vec3 n0 = cornerNormal(0);
  vec3 n1 = cornerNormal(1);
  vec3 n2 = cornerNormal(2);
  return (dot(n0, n1) + dot(n1, n2) + dot(n2, n0)) / 3.0f;
}

RELEVO_FUNCTION float proceduralHeight(
  RELEVO_UNUSED vec3 position, RELEVO_UNUSED vec3 normal, vec3 w)
{
  vec3 s = sin(w * (relevoFrequency * proceduralPi));
  return furFactor() * s.x * s.y * s.z;
}

RELEVO_FUNCTION HeightGradient proceduralGradient(
  RELEVO_UNUSED vec3 position, RELEVO_UNUSED vec3 normal, vec3 w)
{
  float rate = relevoFrequency * proceduralPi;
  vec3 s = sin(w * rate);
  vec3 c = cos(w * rate) * (rate * furFactor());
  HeightGradient gradient;
  gradient.ByPosition = vec3(0.0f);
  gradient.ByWeights = vec3(c.x * s.y * s.z, s.x * c.y * s.z, s.x * s.y * c.z);
  return gradient;
}
