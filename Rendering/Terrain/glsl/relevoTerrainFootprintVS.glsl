// The samples that a pixel at a vertex covers. Follows relevoTerrainFaceVS.glsl.

uniform vec2 relevoHalfViewport; // pixels

// Return the logarithm of the samples that the pixel covers, per side, on the plane of the face
// through a vertex (in VTK's model coordinates).
float relevoDetail(vec3 position)
{
  vec3 step1 = vec3(relevoStep1.x * relevoPlacement.xy + relevoStep1.y * relevoPlacement.zw, 0.0);
  vec3 step2 = vec3(relevoStep2.x * relevoPlacement.xy + relevoStep2.y * relevoPlacement.zw, 0.0);
  float vertexSize = float(1 << relevoUnitShift) * relevoFractions[-RELEVO_FINEST_LEVEL]; // samples
  vec2 climbs = (relevoCorners.yz - relevoCorners.xx) * relevoHeightScale / float(RELEVO_SEGMENTS);
  vec4 clip = MCDCMatrix * vec4(position, 1.0);
  vec4 clip1 = MCDCMatrix * vec4(vertexSize * step1.xy, climbs.x, 0.0);
  vec4 clip2 = MCDCMatrix * vec4(vertexSize * step2.xy, climbs.y, 0.0);
  // Derivatives of the position in the viewport.
  vec2 pixels1 = relevoHalfViewport * (clip1.xy * clip.w - clip.xy * clip1.w) / (clip.w * clip.w);
  vec2 pixels2 = relevoHalfViewport * (clip2.xy * clip.w - clip.xy * clip2.w) / (clip.w * clip.w);
  float pixels = abs(pixels1.x * pixels2.y - pixels1.y * pixels2.x);
  float samples = vertexSize * vertexSize *
    abs(float(relevoStep1.x * relevoStep2.y - relevoStep1.y * relevoStep2.x));
  return 0.5 * log2(max(samples, 1e-30) / max(pixels, 1e-30));
}
