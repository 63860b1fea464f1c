// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   what a vtkAdaptiveLICMapper keeps
 *
 * Private to the mapper's own sources.
 */
#ifndef vtkAdaptiveLICMapperInternals_h
#define vtkAdaptiveLICMapperInternals_h

#include "Buffers/BufferTexture.h"
#include "Changes/Dependencies.h"
#include "Composite/BlockAttributes.h"
#include "Image/LICPassSettings.h"
#include "Passes/LICArray.h"
#include "Passes/LICImage.h"
#include "Passes/LICNoise.h"
#include "Passes/LICProcesses.h"
#include "Passes/LICScreen.h"
#include "vtkAdaptiveLICMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkSmartPointer.h"

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

class vtkCamera;
class vtkFloatArray;
class vtkMultiProcessController;

struct vtkAdaptiveLICMapper::vtkInternals
{
  explicit vtkInternals(vtkAdaptiveLICMapper* self)
    : Root(self)
  {
  }

  // A block of a composite input draws into what its root has, and shows that.
  vtkAdaptiveLICMapper* Root;
  bool IsDrawingVectors = false;       // what the root draws now
  relevo::LICScreen* Screen = nullptr; // that the surface shows now; nullptr for none

  std::string Problem; // said last

  double NoDataMagnitude = 0.0; // of the buffers

  // The vectors of this mapper's polydata.
  vtkOpenGLHelper* Vectors = nullptr; // draws them
  bool HasVectors = false;
  bool AreOfCells = false;
  vtkSmartPointer<vtkFloatArray> Prepared;
  relevo::Dependencies PreparedDependencies;
  void PrepareVectors(vtkAdaptiveLICMapper* self, vtkPolyData* input);
  double Unit = 1.0;       // of the vectors on the graphics card, which then are about 1 long
  bool HasNormals = false; // on the refined surface
  bool HasPointNormals = false;
  relevo::BufferTexture CellVectors; // of VTK's primitives; empty for vectors of points
  relevo::Dependencies CellVectorDependencies;

  // The vectors of all blocks.
  struct VectorFacts
  {
    bool HasFaces = false;
    bool HasArray = false;
    double Longest = -1.0; // negative if there is none
    std::string Problem;   // of an array
    std::string Misplaced; // the array of that name, if the association is another
  };
  relevo::Dependencies VectorDependencies;
  VectorFacts OwnVectors;
  VectorFacts AllVectors; // with those of other processes

  // Of the window that draws.
  relevo::LICNoise Noise;
  relevo::LICImage Image;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  using ScreenKey = std::tuple<vtkRenderer*, vtkActor*, vtkCamera*>;
  std::map<ScreenKey, relevo::LICScreen> Screens;
  unsigned long Use = 0;
  relevo::LICScreen& GetScreen(vtkRenderer* ren, vtkActor* act);

  relevo::LICPassSettings GetPassSettings() const;
  relevo::LICColoring GetColoring() const;
  bool StretchesColors() const;
  void AddSettings(relevo::Dependencies& dependencies) const;

  bool CanShow(vtkRenderer* ren, vtkActor* act);
  void CheckVectors();
  std::string DescribeMisplaced(vtkPolyData* leaf);
  std::string FindVectorProblem() const;
  std::string FindSettingsProblem();
  void SetProblem(const std::string& problem);
  void Prepare(vtkRenderer* ren, vtkActor* act);
  //@{
  /// Have a screen with the LIC; what hinders, as a sentence.
  std::string UpdateScreen(vtkRenderer* ren, vtkActor* act);
  std::string AllocateScreen(vtkRenderer* ren, relevo::LICScreen& screen);
  std::string DrawVectors(
    vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen, std::vector<float>* vectors);
  std::string DrawImage(vtkRenderer* ren, relevo::LICScreen& screen, bool convolve,
    const relevo::LICImage::RangeMerger& merge);
  //@}
  void SetBounds(vtkRenderer* ren, vtkActor* act, relevo::LICScreen& screen);
  relevo::Dependencies GetScreenDependencies(
    vtkRenderer* ren, vtkActor* act, const relevo::LICScreen& screen);
  static void SetVectorUniforms(
    vtkAdaptiveLICMapper* block, vtkShaderProgram* program, vtkRenderer* ren, vtkActor* act);
  void SetImageUniforms(vtkShaderProgram* program);

  // Drawing a picture together with other processes: this one's part while they agree on it.
  struct Part
  {
    vtkActor* Actor = nullptr;           // that the mapper is drawn for
    relevo::LICScreen* Screen = nullptr; // if there are to be streaks
    bool IsChanged = false;
    bool DrawsVectors = false; // else it finds the above
    std::vector<float> Vectors;
    std::string Problem;
  };
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::unique_ptr<Part> LocalContribution;
  std::set<std::pair<vtkRenderer*, vtkActor*>> PreviousContributors;
  bool IsTogether() const;
  void TakePart(vtkRenderer* ren, vtkActor* act);
  bool Agree(bool tookPart, bool& changed);
  int CountRanges(bool convolve) const; // that processes merge
  void DrawTogether(vtkRenderer* ren, vtkActor* act, bool changed);

  /// Calls work(leaf, look) for the meshes of the input.
  template <typename Work>
  void ForEachLeaf(const Work& work);
};

#endif
