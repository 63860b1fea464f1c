// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Compares the same scene drawn by vtkAdaptiveRefinementMapper and by vtkPolyDataMapper.
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

// The picture of a window.
struct RelevoPicture
{
  int Size[2] = { 0, 0 };
  std::vector<unsigned char> Colors; // 3 per pixel
  std::vector<float> Depths;

  explicit RelevoPicture(vtkRenderWindow* window);

  RelevoPicture(int width, int height);

  size_t GetNumberOfPixels() const { return this->Depths.size(); }

  // Number of pixels whose colour differs from the lower left pixel.
  size_t CountForeground() const;

  void Save(const std::string& fileName) const;
};

// Allowed differences between two pictures: pixels whose colour or depth differ by more are
// counted.
struct RelevoTolerance
{
  int Color = 0;
  double Depth = 0.0;
  size_t Pixels = 0;
};

// A window whose actors are either refining (with a vtkAdaptiveRefinementMapper) or their twins
// (with a vtkPolyDataMapper).
class RelevoScene
{
public:
  enum KindType
  {
    Refining,
    Twin
  };

  explicit RelevoScene(KindType kind);

  // Adds an actor of the mesh. Without a recipe, its mapper refines to level 0, and the twin draws
  // the coarse mesh. With a recipe, the twin draws the output of vtkAdaptiveRefinementFilter.
  vtkActor* Add(vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);
  vtkActor* Add(
    vtkRenderer* renderer, vtkDataObject* mesh, vtkAdaptiveRefinement* recipe = nullptr);

  // Creates the mapper of a refining actor. Other modules run tests again with a subclass.
  inline static vtkAdaptiveRefinementMapper* (*NewMapper)(vtkDataObject*) = [](vtkDataObject*)
  { return vtkAdaptiveRefinementMapper::New(); };

  // Where levels are selected. Tests run again with RELEVO_TEST_SELECTION_DEVICE=2 for the GPU.
  static int GetSelectionDevice();

  // How faces are drawn. Tests run again with RELEVO_TEST_METHOD=4 for hardware tessellation.
  static int GetMethod();

  vtkRenderer* AddRenderer(double xmin, double ymin, double xmax, double ymax);
  const std::vector<vtkRenderer*>& GetRenderers() const { return this->Renderers; }

  // Updates what the mappers update automatically.
  void UpdateFilters();

  // Shows everything, from the side set by MoveCamera.
  void ResetCameras();

  void CopyCameras(const RelevoScene& other);

  void Render();

  // Triangles drawn and culled, or polygons of the filters' outputs.
  vtkIdType CountTriangles();
  size_t GetNumberOfFilters() const { return this->Filters.size(); }
  size_t GetNumberOfActors() const { return this->Actors.size(); }
  vtkActor* GetActor(size_t i) { return this->Actors[i]; }
  vtkAdaptiveRefinementMapper* GetMapper(size_t i);

  // Appends all polydata of a composite data set.
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

// Draws scenes twice and compares the pictures. If they differ, it saves both and their difference.
class RelevoComparison
{
public:
  using Builder = std::function<void(RelevoScene&)>;

  RelevoComparison(RelevoCheck& check, int argc, char* argv[]);

  bool Fail(const std::string& text) { return this->Check.Fail(__FILE__, __LINE__, text); }

  // The output folder.
  const std::string& GetFolder() const { return this->Folder; }

  // A change of a scene that was already drawn.
  struct Step
  {
    std::string Name;
    Builder Change;
  };

  // Draws the scene with refining mappers and with their twins from the same cameras, again after
  // each step.
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
