// The height map for relevoHeight.glsl, in vertex and fragment shaders.

uniform sampler2D relevoHeights;
#ifdef RELEVO_HOLES
uniform sampler2D relevoValidity;
#endif

float heightTexel(ivec2 texel)
{
  return texelFetch(relevoHeights, texel, 0).r;
}

float validTexel(ivec2 texel)
{
#ifdef RELEVO_HOLES
  return texelFetch(relevoValidity, texel, 0).r > 0.0 ? 1.0 : 0.0;
#else
  return 1.0;
#endif
}

ivec2 heightSize()
{
  return textureSize(relevoHeights, 0);
}
