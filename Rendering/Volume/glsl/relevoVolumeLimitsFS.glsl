//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// What all cells that a ray passes through ask of it: the depths between which it is seen, and the
// world's length of a depth of 1.

//RELEVO::Ray
#define Scalars float
//RELEVO::Part

uniform sampler2D opaqueDepth;

void main()
{
  initializeLine();
  beginWalk(0.0, texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r);
  gl_FragData[0] = vec4(walkBegin, walkEnd, worldLength, 1.0);
}
