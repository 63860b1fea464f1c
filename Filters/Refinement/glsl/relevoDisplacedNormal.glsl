// Normal of a displaced surface S = B + h D, not normalised.
//
// B's tangents t become t + h dD/dt + D (grad h . t). For a fixed D the second term is zero, and
// the cofactor matrix of I + D grad(h)^T turns N into (1 + grad(h).D) N - (D.N) grad(h). For D = N,
// it is approximated by (h / r) t with the mean radius of curvature r, which is exact on planes and
// spheres: the normal is then (1 + h / r) N - grad(h) up to a factor.
//
//   gradient  grad h, per unit of length
//   stretch   1 + h / r, or 1 for a fixed direction
RELEVO_FUNCTION vec3 displacedNormal(vec3 normal, vec3 direction, vec3 gradient, float stretch)
{
  vec3 tangent = gradient - normal * dot(gradient, normal);
  return normal * (stretch + dot(tangent, direction)) - tangent * dot(direction, normal);
}
