// Fragments of a terrain: its borders, colours by height and slope, and contour lines. Heights need
// relevoTerrainHeightFS.glsl, and slopes relevoTerrainGradient.glsl.

uniform vec2 relevoLastSample; // as relevoRaster

// Return whether a corner of the triangle has no data, or the fragment is beyond the raster.
bool relevoIsOutside()
{
  return relevoMissingVSOutput > 0.0 ||
    any(greaterThan(relevoRasterVSOutput, relevoLastSample));
}

#ifdef RELEVO_ELEVATION
vec4 relevoTerrainColor()
{
  return relevoTableColor(relevoFragmentHeight);
}
#endif

#ifdef RELEVO_SLOPE
vec4 relevoTerrainColor()
{
  return relevoTableColor(degrees(atan(length(relevoGradient))));
}
#endif

#if defined(RELEVO_ASPECT) || defined(RELEVO_RASTER)
uniform float relevoNotANumber;
#endif

#ifdef RELEVO_RASTER
// The sum of numbers, and the share of the pixel that has data.
vec4 relevoTerrainColor()
{
  vec2 number = relevoImageryColor().rg;
  return relevoTableColor(number.y > 0.5 ? number.x / number.y : relevoNotANumber);
}
#endif

#ifdef RELEVO_ASPECT
// Flat parts have no aspect.
vec4 relevoTerrainColor()
{
  vec2 down = -relevoGradient;
  float angle = degrees(atan(down.x, down.y));
  return relevoTableColor(
    down == vec2(0.0) ? relevoNotANumber : (angle < 0.0 ? angle + 360.0 : angle));
}
#endif

#ifdef RELEVO_HILLSHADE
// The sun is in the north-west, 45 degrees above the horizon.
vec4 relevoTerrainColor()
{
#ifdef RELEVO_SOLID
  if (relevoSideVSOutput != 0)
  {
    // The sky shines on walls that face away from the sun.
    float side = dot(relevoSideNormal(), vec3(-0.5, 0.5, 0.70710678));
    return vec4(vec3(0.5 + 0.25 * side), 1.0);
  }
#endif
  vec3 normal = normalize(vec3(-relevoGradient, 1.0));
  float light = dot(normal, vec3(-0.5, 0.5, 0.70710678));
  return vec4(vec3(max(light, 0.0)), 1.0);
}
#endif

#ifdef RELEVO_CONTOURS
uniform vec2 relevoContours; // interval, width in pixels
uniform vec3 relevoContourColor;

vec2 relevoHeightChange = vec2(0.0); // per pixel, to the right and up

// This must run at the start of main(), for all pixels, because it uses derivatives.
void relevoMeasureContours()
{
  relevoHeightChange = vec2(dFdx(relevoFragmentHeight), dFdy(relevoFragmentHeight));
}

// Return the fraction of the pixel that the nearest contour line covers.
float relevoContourCoverage()
{
#ifdef RELEVO_SOLID
  if (relevoSideVSOutput != 0)
  {
    return 0.0;
  }
#endif
  float intervals = relevoFragmentHeight / relevoContours.x;
  float beside = abs(intervals - floor(intervals + 0.5)) * relevoContours.x;
  float change = length(relevoHeightChange);
  float pixels = change > 0.0 ? beside / change : 1e30;
  return clamp(0.5 * relevoContours.y + 0.5 - pixels, 0.0, min(relevoContours.y, 1.0));
}
#endif
