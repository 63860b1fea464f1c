// A patch is one vertex: the index of a face among the drawn ones.

flat out int relevoPatchMember;

void main()
{
  relevoPatchMember = gl_VertexID;
  gl_Position = vec4(0.0);
}
