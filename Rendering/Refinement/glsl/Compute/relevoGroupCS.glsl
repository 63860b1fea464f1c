// What the passes of the stage "group" share.

#define RELEVO_NOT_DRAWN 0xffffffffu // in place of a rank

// Where a key's faces lie, and how they are shared out among instances.
struct RelevoGroup
{
  uint FirstFace;
  uint NumberOfFaces;
  uint FirstInstance;
  uint Copies; // faces per instance; the last one may have less
};
