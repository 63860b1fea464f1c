// The samples that a pixel covers.

uniform ivec2 relevoOrigin; // units of the finest lattice

vec2 relevoRight = vec2(0.0); // changes of the column and row per pixel
vec2 relevoUp = vec2(0.0);

// This must run at the start of main(), for all pixels, because it uses derivatives.
void relevoMeasureFootprint()
{
  relevoRight = dFdx(relevoRasterVSOutput);
  relevoUp = dFdy(relevoRasterVSOutput);
}

// Return the logarithm of the samples that the pixel covers, per side.
float relevoDetail()
{
  return 0.5 * log2(max(abs(relevoRight.x * relevoUp.y - relevoRight.y * relevoUp.x), 1e-30));
}
