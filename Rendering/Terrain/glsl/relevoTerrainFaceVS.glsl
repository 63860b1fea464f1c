// The face of a vertex.

uniform usamplerBuffer relevoFaces;      // apex in the face's lattice, shape, layers of the tiles
uniform samplerBuffer relevoFaceHeights; // morph, heights of the corners
uniform ivec2 relevoOrigin;      // units of the finest lattice
#ifndef RELEVO_GLOBE
uniform float relevoOriginHeight;
uniform vec4 relevoPlacement;    // world coordinates of a step to the next column and row
uniform float relevoHeightScale; // world units per unit of height
#endif

// A tile, in vertices of the lattice of its level.
struct RelevoTile
{
  int Layer;
  ivec2 First;  // vertex
  int Shift;    // logarithm of the vertices of the face's lattice per vertex of the tile
};

int relevoFace;      // index of the face
bool relevoHidden;   // an instance may have more copies of the pattern than faces
int relevoUnitShift; // logarithm of the units of the finest lattice per vertex of the face's
ivec2 relevoApex = ivec2(0);
ivec2 relevoStep1 = ivec2(0);
ivec2 relevoStep2 = ivec2(0);
bool relevoSquare; // the face was made by the bisection of a square
float relevoMorph;
vec3 relevoCorners;
RelevoTile relevoFineTile;
RelevoTile relevoCoarseTile;

// Return a vertex of the face's lattice.
ivec2 relevoFaceVertex(ivec2 ab)
{
  return relevoApex + ab.x * relevoStep1 + ab.y * relevoStep2;
}

// Return the tile that contains a face, from the level of the face's heights and a vertex of that
// level's lattice inside of the face.
RelevoTile relevoTileOf(int layer, int level, ivec2 inside)
{
  RelevoTile tile;
  tile.Layer = layer;
  tile.Shift = max(-level, 0);
  tile.First = (inside >> (tile.Shift + RELEVO_TILE_SHIFT)) << RELEVO_TILE_SHIFT;
  return tile;
}

void relevoLoadFace(int index)
{
  relevoFace = index;
  uvec4 face = texelFetch(relevoFaces, relevoFace);
  vec4 heights = texelFetch(relevoFaceHeights, relevoFace);
  relevoApex = ivec2(face.xy);
  int shape = int(face.z);
  relevoUnitShift = shape & 31;
  relevoStep1 = ivec2((shape >> 5) & 3, (shape >> 7) & 3) - ivec2(1);
  relevoStep2 = ivec2((shape >> 9) & 3, (shape >> 11) & 3) - ivec2(1);
  relevoSquare = ((shape >> 13) & 1) == 0;
  relevoMorph = heights.x;
  relevoCorners = heights.yzw;
  int level = relevoUnitShift + RELEVO_FINEST_LEVEL;
  ivec2 inside = relevoFaceVertex(ivec2(2, 2));
  relevoFineTile = relevoTileOf(int(face.w & 65535u), level, inside);
  relevoCoarseTile = relevoTileOf(int(face.w >> 16), level + 1, inside >> 1);
}

#ifndef RELEVO_BORDER
uniform ivec3 relevoGroup; // first face, number of faces, faces per instance

// Take one of the faces that an instance draws. Return the vertex (a, b) of its pattern.
ivec2 relevoTakeFace()
{
  int member = relevoGroup.x + gl_InstanceID * relevoGroup.z + (gl_VertexID >> 8);
  int end = relevoGroup.x + relevoGroup.y;
  relevoHidden = member >= end;
  relevoLoadFace(min(member, end - 1));
  return ivec2(gl_VertexID & 15, (gl_VertexID >> 4) & 15);
}
#endif
