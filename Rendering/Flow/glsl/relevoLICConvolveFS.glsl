// The convolution, of noise that is tiled from the lower left corner of the picture, or of an image
// that covers the viewport.
uniform sampler2D vectors; // as relevoLICVectorsFS.glsl makes them; zero where nothing is
uniform ivec2 size;
uniform sampler2D noise;
uniform ivec2 noiseSize;
uniform bool noiseIsTiled;
uniform ivec2 noiseOrigin; // of the viewport in the picture, if that is drawn in parts
uniform int steps;
uniform float stepSize;
uniform bool normalized;
uniform bool oriented;
uniform float phase;
uniform float noiseMean;

// Of the pixels with a vector around p.
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
