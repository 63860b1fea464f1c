// The convolution, of noise that is tiled from the lower left corner of the image, or of an image
// that covers the viewport.
uniform sampler2D vectors; // in the format of relevoLICVectorsFS.glsl; zero for empty pixels
uniform ivec2 size;
uniform sampler2D noise;
uniform ivec2 noiseSize;
uniform bool noiseIsTiled;
uniform ivec2 noiseOrigin; // origin of the viewport in a tiled image
uniform int steps;
uniform float stepSize;
uniform bool normalized;
uniform bool oriented;
uniform float phase;
uniform float noiseMean;

// Return the mean of the pixels around p that have a vector.
vec2 licField(vec2 p)
{
  vec3 vector = textureLod(vectors, p / vec2(size), 0.0).xyz;
  return vector.z >= 0.5 ? vector.xy / vector.z : vec2(0.0);
}

float licNoise(vec2 p)
{
  vec2 texel = floor(p);
  texel = noiseIsTiled ? mod(texel + vec2(noiseOrigin), vec2(noiseSize))
                       : clamp(texel, vec2(0.0), vec2(noiseSize - 1));
  return texelFetch(noise, ivec2(texel), 0).r;
}
