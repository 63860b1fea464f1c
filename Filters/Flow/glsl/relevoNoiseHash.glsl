// Hashed random numbers, identical on all processors and in any order. GLSL and C++.

// Returns four random 32-bit numbers for four integers: pcg4d of Jarzynski and Olano, Hash
// Functions for GPU Rendering, Journal of Computer Graphics Techniques 9(3), 2020.
RELEVO_FUNCTION uvec4 noiseHash(ivec4 place)
{
  uvec4 h = uvec4(place) * 1664525u + 1013904223u;
  h.x += h.y * h.w;
  h.y += h.z * h.x;
  h.z += h.x * h.y;
  h.w += h.y * h.z;
  h = h ^ (h >> 16u);
  h.x += h.y * h.w;
  h.y += h.z * h.x;
  h.z += h.x * h.y;
  h.w += h.y * h.z;
  return h;
}

// Converts a random 32-bit number to [0, 1), exactly in float.
RELEVO_FUNCTION float noiseUniform(uint number)
{
  return float(number >> 8u) * (1.0f / 16777216.0f);
}
