// Solid value noise: random numbers at the points of a lattice with smooth interpolation. GLSL and
// C++. The including file provides relevoNoiseHash.glsl.

RELEVO_FUNCTION float solidLatticeValue(ivec3 point, int seed)
{
  return noiseUniform(noiseHash(ivec4(point.x, point.y, point.z, seed)).x);
}

// Returns a value in [0, 1). `cell` is the lower lattice point, `t` in [0, 1] the position in the
// cell.
RELEVO_FUNCTION float solidNoise(ivec3 cell, vec3 t, int seed)
{
  vec3 s = t * t * (3.0f - 2.0f * t);
  float rows[4];
  for (int i = 0; i < 4; ++i)
  {
    ivec3 row = ivec3(cell.x, cell.y + (i & 1), cell.z + (i >> 1));
    rows[i] =
      mix(solidLatticeValue(row, seed), solidLatticeValue(row + ivec3(1, 0, 0), seed), s.x);
  }
  return mix(mix(rows[0], rows[1], s.y), mix(rows[2], rows[3], s.y), s.z);
}
