// What is asked of a part of the ray beyond its scalars: where it is, how steep they are there, and
// what light does to its colours. Gradients are of scalars from 0 to 1 by radii of the mesh.

#if RELEVO_LIT || RELEVO_SURFACES
vec2 partDepths;
#endif

#if RELEVO_LIT || RELEVO_STEEPNESS
uniform mat3 gradientToWorld;
#endif

#if RELEVO_TABLES || RELEVO_GRADIENT_OPACITY
Scalars partSteepness = Scalars(0.0); // lengths of the cell's gradients
#endif

#if RELEVO_STEEPNESS
// Of a gradient as the ray sees it.
float getSteepness(vec3 gradient)
{
  return length(
    gradientToWorld * (gradient.x * rayU + gradient.y * rayV + gradient.z * rayDirection));
}

// In a tetrahedron, by three corners and their scalars, less those of the fourth.
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

uniform samplerBuffer pointGradients; // of each point those of all components
uniform vec4 materials[RELEVO_MATERIALS]; // ambient, diffuse, specular, specular power
#if RELEVO_LIGHTS > 0
uniform vec4 lightPlaces[RELEVO_LIGHTS]; // in the mesh, then w is 1; or the direction in the world
uniform vec3 lightDiffuse[RELEVO_LIGHTS];
uniform vec3 lightSpecular[RELEVO_LIGHTS];
#endif

vec3 walkGradients[RELEVO_MATERIALS]; // where the walk is
vec3 partFrontGradients[RELEVO_MATERIALS];
vec3 partBackGradients[RELEVO_MATERIALS];

// What colours are multiplied by, and what is added.
struct Light
{
  vec3 factor;
  vec3 added;
};
Light partFrontLights[RELEVO_MATERIALS];
Light partBackLights[RELEVO_MATERIALS];

// In a face.
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

// Of a way between two depths, of which the part need not be all.
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
    return Light(vec3(1.0), vec3(0.0)); // as volumeLight() does
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

// At both ends of the part.
void findLights()
{
  for (int i = 0; i < RELEVO_MATERIALS; ++i)
  {
    partFrontLights[i] = getLight(i, partFrontGradients[i], partDepths.x);
    partBackLights[i] = getLight(i, partBackGradients[i], partDepths.y);
  }
}

// The colour that one of the functions gives, at a share of the part.
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
