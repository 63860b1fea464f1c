// The inputs of the fragments of the vectors' pass.
uniform mat4 relevoLICFromVertex;  // from vertexMC to view coordinates
uniform mat3 relevoLICNormals;     // normals from vertexMC to view coordinates
