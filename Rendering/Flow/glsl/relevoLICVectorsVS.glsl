// What the fragments of the vectors' pass need of the surface.
uniform mat4 relevoLICFromVertex;  // from vertexMC to view coordinates
uniform mat3 relevoLICNormals;     // normals, likewise
