// The vector of a fragment in the format of the convolution.
uniform mat3 relevoLICDirections;  // vectors from the model to view coordinates
uniform mat4 relevoLICProjection;  // view coordinates to clip coordinates
uniform vec2 relevoLICSize;        // of the viewport, in pixels
uniform float relevoLICScale;      // scales the longest vector to length 1
uniform float relevoLICThreshold;  // vectors up to this length, before scaling, are masked
uniform int relevoLICMaskOnSurface;

// Return (direction on the screen, 1 if there is a direction, flag). The flag is 1 + depth if there
// are streaks, and the negative of that if the surface is masked.
vec4 relevoLICVector()
{
#ifdef RELEVO_LIC_NORMALS
  vec3 normal = relevoLICNormalVSOutput;
  float tolerance = 1e-4;
#else
  // The normal of the triangle is as exact as the positions are for a pixel.
  vec3 right = dFdx(relevoLICPositionVSOutput);
  vec3 up = dFdy(relevoLICPositionVSOutput);
  vec3 normal = cross(normalize(right), normalize(up));
  float tolerance = 1e-6 * length(relevoLICPositionVSOutput) /
    max(length(normal) * min(length(right), length(up)), 1e-30);
  tolerance = clamp(tolerance, 1e-4, 0.05);
#endif
  float depth = 1.0 + gl_FragCoord.z;
  vec4 none = vec4(0.0, 0.0, 0.0, -depth);
  float normalLength = length(normal);
  vec3 model = relevoLICScale * relevoLICFieldVSOutput.xyz;
  // Vectors that the convolution treats as zero are set to zero here: they have no direction.
  float modelLength = length(model) > 1e-18 ? length(model) / relevoLICScale : 0.0;
  // Below 0.999 a corner of the face has no vector.
  if (relevoLICFieldVSOutput.w < 0.999 || !(normalLength > 0.0))
  {
    return none;
  }
  normal /= normalLength;

  vec3 vector = relevoLICDirections * model;
  vec3 tangent = vector - dot(vector, normal) * normal;
  float tangentLength = length(tangent);
  float share = tangentLength / max(length(vector), 1e-30);
  if (modelLength > 0.0 && share < tolerance)
  {
    return none; // the vector is perpendicular to the surface
  }

  // The direction is that of the projection's derivative along the vector, computed without large
  // numbers.
  vec2 place = 2.0 * gl_FragCoord.xy / relevoLICSize - 1.0;
  vec4 velocity = relevoLICProjection * vec4(tangent / max(tangentLength, 1e-30), 0.0);
  vec2 screen = (velocity.xy - place * velocity.w) * relevoLICSize;
  float speed = length(screen);
  bool moves = speed > 0.0 && modelLength > 0.0;
  screen = moves ? screen / speed * length(tangent.xy) : vec2(0.0);

  float criterion = relevoLICMaskOnSurface != 0 ? modelLength * share : modelLength;
  return vec4(screen, moves ? 1.0 : 0.0, criterion <= relevoLICThreshold ? -depth : depth);
}
