// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeState
 * @brief   the cached selections of a mapper on the GPU
 *
 * Does on the GPU what ViewSelection does on the CPU after tags have been evaluated: faces select
 * patterns again when their tags have changed, and are grouped again when their patterns or the
 * camera have changed. Needs a current context with OpenGL 4.3. Private to the module and its
 * tests.
 */
#ifndef RefinementComputeState_h
#define RefinementComputeState_h

#include "Changes/Dependencies.h"              // for members
#include "Compute/RefinementComputeBuffer.h"   // for members
#include "Compute/RefinementComputeSelector.h" // for members
#include "Compute/RefinementComputeTags.h"     // for members
#include "Compute/RefinementComputeView.h"     // for members
#include "RelevoRenderingRefinementModule.h"   // for export macro
#include "vtkTimeStamp.h"                      // for members

#include <map>    // for members
#include <memory> // for Family
#include <string> // for errors
#include <vector> // for members

class vtkOpenGLRenderWindow;

namespace relevo
{
class EdgeTags;
class FaceCulling;
class PatternFamily;
class PatternLibrary;
class RefinementMesh;
class RefinementPatternBuffer;
struct CullingView;

class RELEVORENDERINGREFINEMENT_EXPORT RefinementComputeState
{
public:
  /// Return whether the GPU can select from these patterns. It cannot for whole numbers of
  /// segments, whose tables are too large.
  static bool CanChooseFrom(const PatternFamily& family);

  //@{
  /**
   * Upload the mesh, the data for culling, and the patterns to select from, each if it has changed.
   * The patterns are all those of a library and of levels up to the maximum. Return false and set
   * GetError() if the GPU cannot hold the data.
   */
  bool UpdateMesh(const RefinementMesh& mesh, vtkMTimeType time);
  bool UpdateCulling(const FaceCulling& culling, vtkMTimeType time);
  bool UpdatePatterns(const PatternLibrary& library,
    const std::shared_ptr<const PatternFamily>& family, int maximumLevel,
    RefinementPatternBuffer& patterns, bool withLines);
  //@}

  /// The buffers that shaders read and write.
  struct Targets
  {
    unsigned int Faces;     // read: sorted corners of each face and one more integer
    unsigned int Instances; // written: one integer per face
    unsigned int MorphTags; // written if vertices morph: three floats per face
  };

  /**
   * Update the selection in a slot. `tags` are values or their evaluator, valid since `levelsTime`;
   * `offset` is added to them. If `camera` is nullptr, all faces are drawn. `hideBackFaces` hides
   * faces that face away from the camera. Return false and set GetError() if the GPU cannot hold
   * the selection.
   */
  bool UpdateView(vtkOpenGLRenderWindow* window, int slot, const EdgeTags& tags, float offset,
    vtkMTimeType levelsTime, const CullingView* camera, bool hideBackFaces, const Targets& targets);

  /// Return the patterns to select from, or nullptr if there are none yet.
  const PatternFamily* GetFamily() const { return this->Family.get(); }

  /// Return the view in a slot that has been updated.
  RefinementComputeView& GetView(int slot) { return this->Views[slot].Selection; }
  /// Return when a slot last changed, or 0 for an empty slot.
  vtkMTimeType GetTime(int slot) const;

  //@{
  /**
   * Wait for the GPU and copy: for each face, the entry of the family that it has selected; for
   * each face a byte, 1 if it is culled; for each key, the number of drawn faces.
   */
  std::vector<unsigned int> ReadEntries(int slot);
  std::vector<unsigned char> ReadHidden(int slot);
  std::vector<int> ReadCounts(int slot);
  //@}

  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources();
  const std::string& GetError() const { return this->Error; }

private:
  struct View
  {
    RefinementComputeView Selection;
    Dependencies LevelDependencies;
    Dependencies SightDependencies;
    vtkTimeStamp GroupsTime;
  };

  bool Fail(const std::string& error);
  bool UpdateTags(const EdgeTags& tags);
  bool Select(View& view, const EdgeTags& tags, float offset, const Targets& targets);

  RefinementComputeSelector Selector;
  RefinementComputeTags Tags;
  RefinementComputeBuffer Values; // tags evaluated on the CPU
  RefinementComputeBuffer FaceEdges;
  std::map<int, View> Views;

  vtkMTimeType MeshTime = 0;
  vtkMTimeType FaceEdgesTime = 0; // of the mesh of FaceEdges
  vtkMTimeType CullingTime = 0;
  std::vector<int> Keys; // keys of the family that are in use
  std::shared_ptr<const PatternFamily> Family;
  Dependencies PatternDependencies;
  bool WithLines = false;
  vtkTimeStamp PatternsTime;
  std::string Error;
};
}

#endif
