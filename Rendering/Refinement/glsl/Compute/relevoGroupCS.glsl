// Shared by the passes of the stage "group".

#define RELEVO_NOT_DRAWN 0xffffffffu // a rank

// The range of a key's faces, and their distribution over instances.
struct RelevoGroup
{
  uint FirstFace;
  uint NumberOfFaces;
  uint FirstInstance;
  uint Copies; // faces per instance; the last one may have fewer
};
