// Positions, gradients and lighting of a segment of the ray. Gradients are of scalars from 0 to 1
// per radius of the mesh.

#if RELEVO_LIT || RELEVO_SURFACES
vec2 partDepths = vec2(0.0);
#endif

#if RELEVO_LIT || RELEVO_STEEPNESS
uniform mat3 gradientToWorld;
#endif

#if RELEVO_TABLES || RELEVO_GRADIENT_OPACITY
Scalars partSteepness = Scalars(0.0); // magnitudes of the cell's gradients
#endif

#if RELEVO_STEEPNESS
// Return the magnitude of a gradient in the ray's coordinates.
float getSteepness(vec3 gradient)
{
  return length(
    gradientToWorld * (gradient.x * rayU + gradient.y * rayV + gradient.z * rayDirection));
}

// Compute the gradient magnitudes in a tetrahedron from three corners and their scalars, relative
// to the fourth.
void setSteepness(vec3 a, vec3 b, vec3 c, Scalars scalarsA, Scalars scalarsB, Scalars scalarsC)
{
  vec3 slopeA = cross(b, c);
  vec3 slopeB = cross(c, a);
  vec3 slopeC = cross(a, b);
  float volume = dot(a, slopeA);
  float inverse = volume != 0.0 ? 1.0 / volume : 0.0;
  for (int i = 0; i < RELEVO_COMPONENTS; ++i)
  {
    componentOf(partSteepness, i) = inverse == 0.0 ? 0.0
      : getSteepness(inverse *
          (componentOf(scalarsA, i) * slopeA + componentOf(scalarsB, i) * slopeB +
            componentOf(scalarsC, i) * slopeC));
  }
}
#endif

#if RELEVO_LIT
//RELEVO::Shading

uniform samplerBuffer pointGradients; // gradients of all components at each point
uniform vec4 materials[RELEVO_MATERIALS]; // ambient, diffuse, specular, specular power
#if RELEVO_LIGHTS > 0
// position in the mesh with w = 1, or direction in world coordinates
uniform vec4 lightPlaces[RELEVO_LIGHTS];
uniform vec3 lightDiffuse[RELEVO_LIGHTS];
uniform vec3 lightSpecular[RELEVO_LIGHTS];
#endif

vec3 walkGradients[RELEVO_MATERIALS]; // at the position of the walk
vec3 partFrontGradients[RELEVO_MATERIALS];
vec3 partBackGradients[RELEVO_MATERIALS];

// The factor and the summand for colours.
struct Light
{
  vec3 factor;
  vec3 added;
};
Light partFrontLights[RELEVO_MATERIALS];
Light partBackLights[RELEVO_MATERIALS];

// Interpolate the gradients in a face.
void walkToGradients(uvec3 ids, vec3 weights)
{
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    ivec3 at = RELEVO_COMPONENTS * ivec3(ids) + ivec3(RELEVO_SHADED_COMPONENT + i);
    walkGradients[i] = weights.x * texelFetch(pointGradients, at.x).xyz +
      weights.y * texelFetch(pointGradients, at.y).xyz +
      weights.z * texelFetch(pointGradients, at.z).xyz;
  }
}

// Set the gradients of the segment, which may be shorter than the interval between the two depths.
void setPartGradients(float begin, float end, vec3 front[RELEVO_MATERIALS])
{
  vec2 shares = clamp((partDepths - vec2(begin)) / (end - begin), 0.0, 1.0);
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    partFrontGradients[i] = mix(front[i], walkGradients[i], shares.x);
    partBackGradients[i] = mix(front[i], walkGradients[i], shares.y);
  }
}

Light getLight(int i, vec3 gradient, float depth)
{
  vec3 normal = gradientToWorld * gradient;
  float steepness = length(normal);
  if (!(steepness > 0.0))
  {
    return Light(vec3(1.0), vec3(0.0)); // the same as in volumeLight()
  }
  Light light = Light(vec3(materials[i].x), vec3(0.0));
#if RELEVO_LIGHTS > 0
  vec3 toEye = -normalize(meshToWorld * rayDirection);
  for (int j = 0; j < RELEVO_LIGHTS; ++j)
  {
    vec4 place = lightPlaces[j];
    vec3 toLight = place.w == 0.0
      ? place.xyz
      : normalize(meshToWorld * (place.xyz - rayOrigin - depth * rayDirection));
    vec2 factors = phongFactors(normal / steepness, toLight, toEye, materials[i].w);
    light.factor += materials[i].y * factors.x * lightDiffuse[j];
    light.added += materials[i].z * factors.y * lightSpecular[j];
  }
#endif
  return light;
}

// Compute the lighting at both ends of the segment.
void findLights()
{
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    partFrontLights[i] = getLight(i, partFrontGradients[i], partDepths.x);
    partBackLights[i] = getLight(i, partBackGradients[i], partDepths.y);
  }
}

// Return the lit colour of one of the functions at a fraction of the segment.
vec3 lightenSet(int i, vec3 color, float share)
{
  return i < RELEVO_MATERIALS
    ? lightenColor(color, mix(partFrontLights[i].factor, partBackLights[i].factor, share),
        mix(partFrontLights[i].added, partBackLights[i].added, share))
    : color;
}

vec3 lightenSurface(int i, vec3 color, float share)
{
  Light light = getLight(i, mix(partFrontGradients[i], partBackGradients[i], share),
    mix(partDepths.x, partDepths.y, share));
  return lightenColor(color, light.factor, light.added);
}
#endif
