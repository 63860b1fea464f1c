// A vertex of a pattern. Two functions define its position on a face:

int relevoInstance();                    // face << 3 | permutation code
vec3 relevoPatternWeights(int code);     // weights of the sorted corners

// (u, v, w), and the index of the copy or, for lines, of the pattern's edge (1 to 3), plus the
// pattern's number / 65536
in vec4 relevoPatternVertex;

int relevoCode = 0; // permutation from the pattern's corners to the sorted ones

vec3 relevoPlaceVertex()
{
  int instance = relevoInstance();
  relevoCode = instance & 7;
  relevoFaceIndex = instance >> 3;
  return relevoPatternWeights(relevoCode);
}

int relevoColorIndex()
{
  return int(fract(relevoPatternVertex.w) * 65536.0);
}

// Return the edges that a line is on. The line's edge lacks one corner of the pattern, which is
// mapped to a sorted corner.
int relevoLineEdges()
{
  float line = floor(relevoPatternVertex.w);
  vec3 lacking = vec3(equal(vec3(line), vec3(2.0, 3.0, 1.0)));
  vec3 sortedLacking = permuteWeights(lacking, relevoCode);
  return line > 0.0 ? (sortedLacking.z > 0.0 ? 1 : (sortedLacking.x > 0.0 ? 2 : 4)) : 0;
}
