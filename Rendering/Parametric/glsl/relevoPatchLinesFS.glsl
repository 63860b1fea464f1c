// Lines of constant width in pixels on a fragment's patch: isolines of its field, and the borders
// of the patch. Follows relevoPatch.glsl and relevoPatchFieldFS.glsl.

#ifdef RELEVO_ISOLINES
uniform vec3 relevoIsolines; // spacing, bias modulo the spacing, width in pixels
uniform vec3 relevoIsolineColor;
#endif
#ifdef RELEVO_PATCH_EDGES
uniform float relevoPatchEdgeWidth;
uniform vec3 relevoPatchEdgeColor;
#endif

vec2 relevoAcross = vec2(0.0); // change of u per pixel, to the right and up
vec2 relevoAlong = vec2(0.0);  // change of v per pixel

// This must run at the start of main(), for all pixels, because it uses derivatives.
void relevoMeasurePixels()
{
  vec2 right = dFdx(relevoPatchCoordinateVSOutput);
  vec2 up = dFdy(relevoPatchCoordinateVSOutput);
  relevoAcross = vec2(right.x, up.x);
  relevoAlong = vec2(right.y, up.y);
}

// Return the distance in pixels to where a value is zero, from its change per pixel.
float relevoPixelsTo(float number, vec2 change)
{
  float size = length(change);
  return size > 0.0 ? abs(number) / size : 1e30;
}

// Return the fraction of the pixel that the line covers.
float relevoCoverage(float pixels, float width)
{
  return clamp(0.5 * width + 0.5 - pixels, 0.0, min(width, 1.0));
}

#ifdef RELEVO_ISOLINES
float relevoIsolineCoverage(FieldNumber number)
{
  float spacings = (number.Exact + relevoIsolines.y) / relevoIsolines.x;
  float beside = (spacings - floor(spacings + 0.5)) * relevoIsolines.x;
  vec2 change = number.Slope.x * relevoAcross + number.Slope.y * relevoAlong;
  return relevoCoverage(relevoPixelsTo(beside, change), relevoIsolines.z);
}
#endif

#ifdef RELEVO_PATCH_EDGES
// Return the distance to a border, if the fragment is in the part of the patch next to it. If a
// patch is seen edge-on, all of it would seem near.
float relevoPixelsFrom(float number, vec2 change)
{
  return number < 0.25 ? relevoPixelsTo(number, change) : 1e30;
}

// Return the distance to the nearest border, without degenerate borders and those that are not
// edges, in the order of findPatchBorder().
float relevoPixelsToBorder()
{
  bool isTriangle = (relevoPatchVSOutput.y & 256) != 0;
  int hidden = relevoPatchVSOutput.y >> 9;
  vec2 uv = relevoPatchCoordinateVSOutput;
  vec4 borders = vec4(uv.y, uv.x, isTriangle ? 1.0 - uv.x - uv.y : 1.0 - uv.y, 1.0 - uv.x);
  float v = relevoPixelsFrom(borders.x, relevoAlong);
  float u = relevoPixelsFrom(borders.y, relevoAcross);
  float opposite = relevoPixelsFrom(borders.z, isTriangle ? relevoAcross + relevoAlong : relevoAlong);
  float last = relevoPixelsFrom(borders.w, relevoAcross);
  float nearest = 1e30;
  nearest = (hidden & 1) != 0 ? nearest : min(nearest, v);
  nearest = (hidden & 2) != 0 ? nearest : min(nearest, u);
  nearest = (hidden & 4) != 0 ? nearest : min(nearest, opposite);
  return isTriangle || (hidden & 8) != 0 ? nearest : min(nearest, last);
}
#endif
