// A patch is one vertex, the number of a face among those to be drawn.

flat out int relevoPatchMember;

void main()
{
  relevoPatchMember = gl_VertexID;
  gl_Position = vec4(0.0);
}
