// Combines colours of the surface with its LIC.
uniform int relevoLICColorMode;     // 0 blend, 1 multiply
uniform float relevoLICIntensity;
uniform float relevoLICBias;

vec3 relevoLICCombine(vec3 color, float lic)
{
  return relevoLICColorMode == 0 ? mix(color, vec3(lic), relevoLICIntensity)
                                 : color * clamp(lic + relevoLICBias, 0.0, 1.0);
}

// Return the lightness of the HSL model.
float relevoLightness(vec3 color)
{
  return 0.5 * (min(min(color.r, color.g), color.b) + max(max(color.r, color.g), color.b));
}

// Set the lightness; hue and saturation do not change.
vec3 relevoSetLightness(vec3 color, float lightness)
{
  float old = relevoLightness(color);
  float room = 1.0 - abs(2.0 * old - 1.0);
  float newRoom = 1.0 - abs(2.0 * lightness - 1.0);
  return vec3(lightness) + (room > 0.0 ? (color - vec3(old)) * (newRoom / room) : vec3(0.0));
}
