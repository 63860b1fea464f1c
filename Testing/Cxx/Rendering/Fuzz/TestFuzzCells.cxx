// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random unstructured grids, valid or not, crash or hang no class that accepts them.
// Every invalid cell is reported, and no valid cell is.
#include "RelevoCheck.h"
#include "RelevoFuzz.h"
#include "RelevoRandomGrid.h"

#include "vtkActor.h"
#include "vtkAdaptiveCurveFilter.h"
#include "vtkAdaptiveCurveMapper.h"
#include "vtkAdaptivePatchMapper.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkAdaptiveRefinementFilter.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkGPUUnstructuredGridVolumeMapper.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkMeshVisibilitySort.h"
#include "vtkPatchSurface.h"
#include "vtkPatchSurfaceFilter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkVolumeRayCastFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#ifdef __unix__
#include <sys/time.h>
#endif

namespace
{
using RelevoFuzz::Call;
using RelevoFuzz::Dice;

constexpr int Size = 24;            // pixels per side of a picture
constexpr int MaximumSeconds = 300; // llvmpipe of Mesa 26 needs 12 for a shader of curved cells

vtkSmartPointer<vtkCamera> MakeCamera()
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(2.5, 2.0, 3.0);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetClippingRange(0.1, 100.0);
  return camera;
}

vtkSmartPointer<vtkAdaptiveRefinement> MakeRecipe()
{
  auto recipe = vtkSmartPointer<vtkAdaptiveRefinement>::New();
  recipe->SetMaximumLevel(1);
  recipe->SetSurface(vtkNew<vtkPatchSurface>());
  return recipe;
}

// Ends the process after this computing time, in case a class hangs.
void LimitTime(int seconds)
{
#ifdef __unix__
  const itimerval limit = { { 0, 0 }, { seconds, 0 } };
  setitimer(ITIMER_PROF, &limit, nullptr);
#else
  static_cast<void>(seconds);
#endif
}

// One in this many grids is drawn too. Most of the time is spent on building shaders.
int GetDrawnShare()
{
  const char* share = std::getenv("RELEVO_FUZZ_DRAWN");
  return share ? std::max(std::atoi(share), 1) : 1;
}

// The messages of an object about one grid.
class Reports
{
public:
  explicit Reports(vtkObject* object)
    : Object(object)
  {
    this->Tag = object->AddObserver(vtkCommand::ErrorEvent, this, &Reports::Take);
  }
  ~Reports() { this->Object->RemoveObserver(this->Tag); }
  Reports(const Reports&) = delete;
  void operator=(const Reports&) = delete;
  const std::string& GetText() const { return this->Text; }
  bool Has(const char* words) const { return this->Text.find(words) != std::string::npos; }

private:
  void Take(vtkObject*, unsigned long, void* text) { this->Text += static_cast<const char*>(text); }
  vtkObject* Object;
  unsigned long Tag;
  std::string Text;
};

// Windows and mappers for all runs, so that programs are built once.
struct Stage
{
  Stage()
  {
    this->Renderer->SetActiveCamera(MakeCamera());
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Size, Size);
    this->Window->AddRenderer(this->Renderer);
    this->Property->GetScalarOpacity()->AddPoint(0.0, 0.2);
    this->Property->GetScalarOpacity()->AddPoint(1.0, 0.9);
    this->Property->GetRGBTransferFunction()->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
    this->Property->GetRGBTransferFunction()->AddRGBPoint(1.0, 0.0, 1.0, 1.0);
    this->Volume->SetMapper(this->VolumeMapper);
    this->Volume->SetProperty(this->Property);
    this->Curves->SetRefinement(MakeRecipe());
    this->PatchActor->SetMapper(this->Patches);
    this->CurveActor->SetMapper(this->Curves);
  }
  void Draw(vtkProp* prop)
  {
    this->Renderer->AddViewProp(prop);
    this->Window->Render();
    this->Renderer->RemoveViewProp(prop);
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkGPUUnstructuredGridVolumeMapper> VolumeMapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkAdaptivePatchMapper> Patches;
  vtkNew<vtkActor> PatchActor;
  vtkNew<vtkAdaptiveCurveMapper> Curves;
  vtkNew<vtkActor> CurveActor;
};

Stage& GetStage()
{
  static Stage stage;
  return stage;
}

class Machine
{
public:
  explicit Machine(Dice& dice)
    : D(dice)
    , Grid(dice)
  {
  }

  std::vector<Call> GetCalls()
  {
    return { { "a grid with " +
        (this->Grid.GetError().empty() ? std::string("no fault") : this->Grid.GetError()),
      [this] { this->TakeAll(); } } };
  }

  std::string FindError() { return this->Error; }

private:
  void TakeAll()
  {
    LimitTime(MaximumSeconds);
    vtkObject::GlobalWarningDisplayOn(); // otherwise there are no events
    this->Sort();
    this->Cast();
    this->MakePatches();
    this->MakeCurves();
    const int share = GetDrawnShare();
    if (share == 1 || this->D.Once(share))
    {
      this->DrawVolume();
      this->DrawSurface();
      this->DrawCurves();
    }
    vtkObject::GlobalWarningDisplayOff();
    LimitTime(0);
  }

  // Points that are not finite are not an error for volumes, nor in cells that a class ignores.
  void Judge(const char* name, const Reports& reports, bool takesInfinite)
  {
    const bool hasError = !this->Grid.GetError().empty();
    const bool concerns =
      !this->Grid.IsOfPoints() || (!takesInfinite && this->Grid.GetDimension() > 1);
    if (hasError && this->Grid.IsCertain() && concerns && reports.GetText().empty())
    {
      this->Error += std::string(name) + " does not report " + this->Grid.GetError() + "; ";
    }
    if (!hasError && reports.Has("left out"))
    {
      this->Error = std::string(name) + " reports of a sound grid: " + reports.GetText();
    }
  }

  void Sort()
  {
    vtkNew<vtkMeshVisibilitySort> sort;
    const Reports reports(sort);
    sort->SetInput(this->Grid.Get());
    sort->SetCamera(MakeCamera());
    sort->InitTraversal();
    std::set<vtkIdType> seen;
    while (vtkIdTypeArray* cells = sort->GetNextCells())
    {
      for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
      {
        const vtkIdType cell = cells->GetValue(i);
        if (cell < 0 || cell >= this->Grid.Get()->GetNumberOfCells() || !seen.insert(cell).second)
        {
          this->Error = "the sort returns a cell twice, or one that does not exist";
        }
      }
    }
    this->Judge("vtkMeshVisibilitySort", reports, true);
  }

  void Cast()
  {
    vtkNew<vtkVolumeRayCastFilter> filter;
    const Reports reports(filter);
    filter->SetInputData(this->Grid.Get());
    filter->SetCamera(MakeCamera());
    filter->SetVolumeProperty(GetStage().Property);
    filter->SetViewportSize(Size, Size);
    filter->Update();
    this->Judge("vtkVolumeRayCastFilter", reports, true);
    auto* colors = vtkDoubleArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
    for (vtkIdType i = 0; colors && i < colors->GetNumberOfValues(); ++i)
    {
      if (!std::isfinite(colors->GetValue(i)))
      {
        this->Error = "a color is not finite";
      }
    }
  }

  void MakePatches()
  {
    vtkNew<vtkPatchSurfaceFilter> filter;
    const Reports reports(filter);
    filter->SetInputData(this->Grid.Get());
    filter->SetSplitPatches(this->D.Once(2));
    filter->Update();
    this->Judge("vtkPatchSurfaceFilter", reports, false);
    if (filter->GetOutput()->GetNumberOfCells() == 0)
    {
      return;
    }
    vtkNew<vtkAdaptiveRefinementFilter> refined;
    const Reports refinedReports(refined);
    refined->SetInputConnection(filter->GetOutputPort());
    refined->SetRefinement(MakeRecipe());
    refined->Update();
    vtkPolyData* mesh = refined->GetOutput();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* x = mesh->GetPoint(i);
      if (!std::isfinite(x[0] + x[1] + x[2]))
      {
        this->Error = "a point of the refined patches is not finite";
      }
    }
  }

  void JudgeCurves(const char* name, const Reports& reports)
  {
    const bool concerns = this->Grid.GetDimension() == 1 && this->Grid.IsCertain();
    if (concerns && reports.GetText().empty())
    {
      this->Error = std::string(name) + " does not report " + this->Grid.GetError();
    }
    if (this->Grid.GetError().empty() && reports.Has("left out"))
    {
      this->Error = std::string(name) + " reports of a sound grid: " + reports.GetText();
    }
  }

  void MakeCurves()
  {
    vtkNew<vtkAdaptiveCurveFilter> filter;
    const Reports reports(filter);
    filter->SetInputData(this->Grid.Get());
    filter->SetRefinement(MakeRecipe());
    filter->SetRepresentationToTubes();
    filter->SetRadius(0.1);
    filter->Update();
    this->JudgeCurves("vtkAdaptiveCurveFilter", reports);
  }

  void DrawVolume()
  {
    Stage& stage = GetStage();
    const Reports reports(stage.VolumeMapper);
    stage.VolumeMapper->SetInputData(this->Grid.Get());
    // Random cells are bent: with the defaults, each would have thousands of pieces.
    const bool isFine = this->D.Once(40);
    stage.VolumeMapper->SetShapeTolerance(isFine ? 5e-4 : 0.1);
    stage.VolumeMapper->SetFieldTolerance(isFine ? 4e-3 : 0.3);
    this->D.Once(3) ? stage.VolumeMapper->SetMethodToCellProjection()
                    : stage.VolumeMapper->SetMethodToRayCasting();
    stage.Draw(stage.Volume);
    this->Judge("vtkGPUUnstructuredGridVolumeMapper", reports, true);
  }

  void DrawSurface()
  {
    Stage& stage = GetStage();
    const Reports reports(stage.Patches);
    stage.Patches->SetInputData(this->Grid.Get());
    stage.Draw(stage.PatchActor);
    this->Judge("vtkAdaptivePatchMapper", reports, false);
  }

  void DrawCurves()
  {
    Stage& stage = GetStage();
    const Reports reports(stage.Curves);
    stage.Curves->SetInputDataObject(this->Grid.Get());
    stage.Draw(stage.CurveActor);
    this->JudgeCurves("vtkAdaptiveCurveMapper", reports);
  }

  Dice& D;
  RelevoFuzz::RandomGrid Grid;
  std::string Error;
};
}

int TestFuzzCells(int, char*[])
{
  RelevoCheck check;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  int grids = 0;
  CHECK_EQUAL(RelevoFuzz::Run<Machine>(250, 1, grids), 0);
  std::cout << grids << " grids\n";
  return check.GetResult();
}
