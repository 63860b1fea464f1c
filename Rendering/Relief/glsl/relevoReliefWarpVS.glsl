// The relief's plane, with vtkReliefWarper's image.
uniform mat4 reliefToClip;
uniform vec4 warpCoefficients;
uniform vec4 reliefFirstAndSize;
out vec2 warpedPlaceVSOutput;

vec4 reliefPlanePosition()
{
  bvec2 far = bvec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4,
    gl_VertexID == 2 || gl_VertexID >= 4);
  warpedPlaceVSOutput = vec2(far) * reliefFirstAndSize.zw - 0.5;
  return reliefToClip *
    vec4(warpedPlaceVSOutput - reliefFirstAndSize.xy, warpCoefficients.w, 1.0);
}
