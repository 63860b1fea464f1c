// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   the tags of the edges of faces, for all kinds of tags
 */
#ifndef FaceTags_h
#define FaceTags_h

#include "Evaluation/EdgeTags.h"
#include "Levels/EdgeLevels.h"
#include "Mathematics/RefinementMathematics.h"
#include "Mesh/RefinementMesh.h"

#include <algorithm> // for std::fill_n

namespace relevo
{
/**
 * Call work(getTags) once. getTags(f, face, t) gets the tags of the sorted edges (0,1), (1,2),
 * (0,2) of face f, without offset and clamping. This is a template so that the compiler generates
 * loops over faces without branches.
 */
template <typename Work>
void WithFaceTags(const EdgeTags& tags, int maximumLevel, const Work& work)
{
  const float* values = tags.GetValues();
  switch (tags.GetKind())
  {
    case EdgeTags::UNIFORM:
      work([maximumLevel](vtkIdType, const RefinementFace&, float t[3])
        { std::fill_n(t, 3, static_cast<float>(maximumLevel)); });
      break;
    case EdgeTags::PER_POINT:
      work(
        [values](vtkIdType, const RefinementFace& face, float t[3])
        {
          const float a = values[face.Corners[0]];
          const float b = values[face.Corners[1]];
          const float c = values[face.Corners[2]];
          t[0] = meanTag(a, b);
          t[1] = meanTag(b, c);
          t[2] = meanTag(a, c);
        });
      break;
    case EdgeTags::PER_EDGE:
      work(
        [values, edges = tags.GetFaceEdges().data()](vtkIdType f, const RefinementFace&, float t[3])
        {
          for (int e = 0; e < 3; ++e)
          {
            t[e] = values[edges[3 * f + e]];
          }
        });
      break;
  }
}
}

#endif
