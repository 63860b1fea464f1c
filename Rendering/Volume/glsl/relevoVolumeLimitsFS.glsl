//VTK::System::Dec
//VTK::Output::Dec
//RELEVO::Defines
// The data of a ray that all cells use: the visible range of depths, and the world length of a unit
// of depth.

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
