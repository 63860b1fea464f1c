// Tests for faces that a camera cannot see. GLSL and C++.

// Whether a box (its centre and half its sides) is completely outside a plane, whose positive side
// is inside.
RELEVO_FUNCTION bool isBoxBeyond(vec3 middle, vec3 halfSides, vec4 plane)
{
  vec3 normal = vec3(plane);
  return dot(normal, middle) + dot(abs(normal), halfSides) + plane.w < 0.0f;
}

// Whether all normals in a cone face away from the eye. `toEye` is the vector from the centre of a
// box to the eye. No point of the face is further behind the centre than `reach` along any normal.
// With a parallel camera, `toEye` is any vector towards it and `reach` is 0. A cosine of 0 or less
// does not bound the normals.
RELEVO_FUNCTION bool facesAway(vec3 axis, float cosine, vec3 toEye, float reach)
{
  if (!(cosine > 0.0f))
  {
    return false;
  }
  // The largest dot product of the vector with a normal of the cone.
  float along = dot(axis, toEye);
  float across = sqrt(max(dot(toEye, toEye) - along * along, 0.0f));
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  // A face that is seen nearly edge-on can still cover pixels.
  float edgeOn = 0.1f * length(toEye);
  return along < 0.0f && along * cosine + across * sine < -reach - edgeOn;
}
