// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// The same scene drawn by vtkAdaptiveRefinementMapper and by vtkPolyDataMapper, to compare.
#ifndef RelevoScene_h
#define RelevoScene_h

#include "RelevoCheck.h"

#include "vtkActor.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkAdaptiveRefinementMapper.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

// What a window shows.
struct RelevoPicture
{
  int Size[2] = { 0, 0 };
  std::vector<unsigned char> Colors; // 3 per pixel
  std::vector<float> Depths;

  explicit RelevoPicture(vtkRenderWindow* window);

  RelevoPicture(int width, int height);

  size_t GetNumberOfPixels() const { return this->Depths.size(); }

  // Pixels of another colour than the lower left one.
  size_t CountForeground() const;

  void Save(const std::string& fileName) const;
};

// How far two pictures may differ: pixels whose colour or depth differ by more are counted.
struct RelevoTolerance
{
  int Color = 0;
  double Depth = 0.0;
  size_t Pixels = 0;
};

// A window with renderers whose actors are refining (their mapper is a
// vtkAdaptiveRefinementMapper) or their twins (a vtkPolyDataMapper).
class RelevoScene
{
public:
  enum KindType
  {
    Refining,
    Twin
  };

  explicit RelevoScene(KindType kind);

  // An actor of the mesh. Without a recipe its mapper refines to level 0, and the twin's draws the
  // coarse mesh; with one, the twin's draws what vtkAdaptiveRefinementFilter makes of the mesh.
  vtkActor* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);
  vtkActor* Add(
    vtkRenderer* renderer, vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);

  // The mapper of a refining actor. Tests of other modules run again with a subclass.
  inline static vtkAdaptiveRefinementMapper* (*NewMapper)(vtkDataObject*) = [](vtkDataObject*)
  { return vtkAdaptiveRefinementMapper::New(); };

  // Where faces choose their patterns: tests run again with RELEVO_TEST_SELECTION_DEVICE=2, for
  // the GPU.
  static int GetSelectionDevice();

  // How faces are drawn: tests run again with RELEVO_TEST_METHOD=4, for hardware tessellation.
  static int GetMethod();

  vtkRenderer* AddRenderer(double xmin, double ymin, double xmax, double ymax);
  const std::vector<vtkRenderer*>& GetRenderers() const { return this->Renderers; }

  // What the mappers find out by themselves.
  void UpdateFilters();

  // See everything, from the side that MoveCamera says.
  void ResetCameras();

  void CopyCameras(const RelevoScene& other);

  void Render();

  // Triangles drawn and culled, or polygons of the filters' outputs.
  vtkIdType CountTriangles();
  size_t GetNumberOfFilters() const { return this->Filters.size(); }
  size_t GetNumberOfActors() const { return this->Actors.size(); }
  vtkActor* GetActor(size_t i) { return this->Actors[i]; }
  vtkAdaptiveRefinementMapper* GetMapper(size_t i);

  // All polydata of a composite data set in one.
  static vtkSmartPointer<vtkPolyData> Append(vtkDataObject* data);

  const KindType Kind;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  // Applied to each camera after it was reset to show everything.
  std::function<void(vtkCamera*)> MoveCamera = [](vtkCamera* camera)
  {
    camera->Azimuth(25.0);
    camera->Elevation(20.0);
  };

private:
  void AddRenderer(vtkRenderer* renderer);

  std::vector<vtkRenderer*> Renderers;
  std::vector<vtkActor*> Actors;
  std::vector<
    std::pair<vtkSmartPointer<vtkAdaptiveRefinementFilter>, std::pair<vtkActor*, vtkRenderer*>>>
    Filters;
};

// Draws scenes twice and compares the pictures; keeps both and their difference when they differ.
class RelevoComparison
{
public:
  using Builder = std::function<void(RelevoScene&)>;

  RelevoComparison(RelevoCheck& check, int argc, char* argv[]);

  bool Fail(const std::string& text) { return this->Check.Fail(__FILE__, __LINE__, text); }

  // To write into.
  const std::string& GetFolder() const { return this->Folder; }

  // A change of a scene that was drawn already.
  struct Step
  {
    std::string Name;
    Builder Change;
  };

  // Draw the scene with refining mappers and with their twins, from the same cameras; then again
  // after each step.
  bool Compare(const std::string& name, const RelevoTolerance& tolerance, const Builder& build,
    const std::vector<Step>& steps = {});

  bool Compare(const std::string& name, const RelevoTolerance& tolerance,
    const RelevoPicture& actual, const RelevoPicture& expected);

private:
  bool CompareNow(const std::string& name, const RelevoTolerance& tolerance, RelevoScene& refining,
    RelevoScene& twin);

  RelevoCheck& Check;
  std::string Folder;
  std::string Only;
};

#endif
