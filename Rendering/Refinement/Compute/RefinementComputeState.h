// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   RefinementComputeState
 * @brief   a mapper's selections on the GPU, kept until something changes
 *
 * What ViewSelection does on the CPU once tags are known: faces choose their patterns anew when
 * their tags changed, and are grouped anew when their patterns or the camera changed. Needs a
 * current context with OpenGL 4.3. Private to the module and its
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
  /// Whether faces can choose from these patterns on the GPU: not from whole numbers of segments,
  /// whose tables are too large.
  static bool CanChooseFrom(const PatternFamily& family);

  //@{
  /**
   * Take the mesh, what hides its faces, and the patterns that they can choose, of a library and of
   * levels up to the maximum, all of which are loaded; each if it has changed. False, with
   * GetError(), when the GPU cannot hold it.
   */
  bool UpdateMesh(const RefinementMesh& mesh, vtkMTimeType time);
  bool UpdateCulling(const FaceCulling& culling, vtkMTimeType time);
  bool UpdatePatterns(const PatternLibrary& library,
    const std::shared_ptr<const PatternFamily>& family, int maximumLevel,
    RefinementPatternBuffer& patterns, bool withLines);
  //@}

  /// Buffers that shaders draw from.
  struct Targets
  {
    unsigned int Faces;     // read: sorted corners of each face, and one more integer
    unsigned int Instances; // written, one integer a face
    unsigned int MorphTags; // written where vertices morph, three floats a face
  };

  /**
   * Bring the selection in a slot up to date. `tags`, values or what evaluates them, are those of
   * the time `levelsTime`, and `offset` is added; `camera` is nullptr to draw all faces, and with
   * `hideBackFaces` faces that face away from it are hidden. False, with GetError(), when the GPU
   * cannot hold it.
   */
  bool UpdateView(vtkOpenGLRenderWindow* window, int slot, const EdgeTags& tags, float offset,
    vtkMTimeType levelsTime, const CullingView* camera, bool hideBackFaces, const Targets& targets);

  /// The patterns that faces choose from; nullptr for none yet.
  const PatternFamily* GetFamily() const { return this->Family.get(); }

  /// The view in a slot that has been updated.
  RefinementComputeView& GetView(int slot) { return this->Views[slot].Selection; }
  /// When what is in a slot last changed; 0 where nothing is.
  vtkMTimeType GetTime(int slot) const;

  //@{
  /**
   * Wait for the GPU and copy: the entry of the family that each face has chosen; a byte per face,
   * 1 where it is culled; how many faces are drawn of each key.
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
  RefinementComputeBuffer Values; // of tags that the CPU has evaluated
  RefinementComputeBuffer FaceEdges;
  std::map<int, View> Views;

  vtkMTimeType MeshTime = 0;
  vtkMTimeType FaceEdgesTime = 0; // of their mesh
  vtkMTimeType CullingTime = 0;
  std::vector<int> Keys; // of the family, those in use
  std::shared_ptr<const PatternFamily> Family;
  Dependencies PatternDependencies;
  bool WithLines = false;
  vtkTimeStamp PatternsTime;
  std::string Error;
};
}

#endif
