// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that random calls of vtkSurfaceIntersectionFilter, on random meshes and recipes, never
// crash, refer to existing cells, and give the result of a new filter.
#include "RelevoCheck.h"
#include "RelevoFuzzRecipe.h"
#include "RelevoIntersections.h"

#include "vtkCellData.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkSurfaceIntersectionFilter.h"

#include <cmath>
#include <sstream>

namespace
{
using RelevoFuzz::Call;
using RelevoFuzz::Dice;

// Whether all ids are valid cells, or -1 for several cells.
bool HasIds(vtkPolyData* output, const char* name, vtkPolyData* input)
{
  vtkDataArray* ids = output->GetCellData()->GetArray(name);
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const double id = ids->GetComponent(i, 0);
    if (id < -1.0 || id >= static_cast<double>(input->GetNumberOfCells()))
    {
      return false;
    }
  }
  return true;
}

// Whether both filters have the array with the same values, or neither has it.
bool IsSameArray(vtkPolyData* mesh, vtkPolyData* other, const char* name)
{
  vtkDataArray* own = mesh->GetCellData()->GetArray(name);
  vtkDataArray* others = other->GetCellData()->GetArray(name);
  bool isSame = (own != nullptr) == (others != nullptr) &&
    (!own || own->GetNumberOfTuples() == others->GetNumberOfTuples());
  for (vtkIdType i = 0; isSame && own && i < own->GetNumberOfTuples(); ++i)
  {
    isSame = own->GetComponent(i, 0) == others->GetComponent(i, 0);
  }
  return isSame;
}

class Machine
{
public:
  explicit Machine(Dice& dice)
    : D(dice)
    , Recipe(dice)
  {
    this->NewInput(0);
    this->NewInput(1);
  }

  std::vector<Call> GetCalls()
  {
    std::vector<Call> calls = { { "recipe", [this] { this->NewRecipe(); } },
      { "input", [this] { this->NewInput(this->D.Throw(2)); } },
      { "input", [this] { this->NewInput(this->D.Throw(2)); } },
      { "inputs are swapped", [this] { this->Swap(); } },
      { "an input is the other", [this] { this->Meshes[1] = this->Meshes[0]; } },
      { "an input is what was refined", [this] { this->TakeRefined(); } },
      { "one input", [this] { this->Meshes[1] = nullptr; } },
      { "point", [this] { this->MovePoint(); } }, { "matrix", [this] { this->NewMatrix(); } },
      { "settings", [this] { this->Set(); } } };
    for (int i = 0; i < 12; ++i)
    {
      calls.push_back({ "update", [this] { this->Update(); } });
    }
    this->Recipe.AddTo(calls);
    return calls;
  }

  std::string FindError() { return this->Error; }

private:
  void NewInput(int side) { this->Meshes[side] = RelevoFuzz::MakeMesh(this->D); }
  void NewRecipe()
  {
    this->Recipe.Renew();
    this->Filter->SetRefinement(this->D.Throw(2), this->D.Once(4) ? nullptr : this->Recipe.Get());
  }
  void Swap()
  {
    if (this->Meshes[1])
    {
      std::swap(this->Meshes[0], this->Meshes[1]);
    }
  }
  void TakeRefined()
  {
    const int side = this->D.Throw(2);
    if (vtkPolyData* refined = this->Filter->GetRefinedSurface(side))
    {
      this->Meshes[side] = refined;
      this->Filter->SetRefinement(side, nullptr);
    }
  }
  void MovePoint()
  {
    vtkPoints* points = this->Meshes[0]->GetPoints();
    if (points && points->GetNumberOfPoints() > 0)
    {
      points->SetPoint(this->D.Throw(static_cast<int>(points->GetNumberOfPoints())),
        this->D.Share(), this->D.Share(), this->D.Share());
      points->Modified();
    }
  }
  void NewMatrix()
  {
    vtkNew<vtkMatrix4x4> matrix;
    const bool isHostile = this->D.Once(4);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        matrix->SetElement(
          row, column, isHostile ? this->D.Number() : 0.25 * (this->D.Throw(9) - 4.0));
      }
    }
    this->Filter->SetMatrix(this->D.Throw(2), this->D.Once(3) ? nullptr : matrix.Get());
  }
  void Set()
  {
    this->Filter->SetTolerance(std::abs(this->D.Number()));
    this->Filter->SetContactDistance(this->D.Number());
    this->Filter->SetJoinSegments(this->D.Once(2));
    this->Filter->SetClassify(this->D.Once(2));
  }
  void Connect(vtkSurfaceIntersectionFilter* filter)
  {
    for (int side = 0; side < 2; ++side)
    {
      filter->SetInputData(side, this->Meshes[side]);
    }
  }
  void Update()
  {
    this->Connect(this->Filter);
    std::ostringstream text;
    this->Filter->Print(text);
    this->Filter->Update();
    this->CheckOutputs();
    this->CompareToNew();
  }
  void CheckOutputs()
  {
    vtkPolyData* meshes[2] = { this->Meshes[0], this->Meshes[this->Meshes[1] ? 1 : 0] };
    for (int port = 0; port < 2; ++port)
    {
      vtkPolyData* output = this->Filter->GetOutput(port);
      for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
      {
        const double* x = output->GetPoint(i);
        if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        {
          this->Error = "a point is not finite";
        }
      }
      if (!HasIds(output, "Input0CellID", meshes[0]) || !HasIds(output, "Input1CellID", meshes[1]))
      {
        this->Error = "a cell meets that does not exist";
      }
    }
  }
  void CompareToNew()
  {
    vtkNew<vtkSurfaceIntersectionFilter> fresh;
    this->Connect(fresh);
    for (int side = 0; side < 2; ++side)
    {
      fresh->SetRefinement(side, this->Filter->GetRefinement(side));
      fresh->SetMatrix(side, this->Filter->GetMatrix(side));
    }
    fresh->SetTolerance(this->Filter->GetTolerance());
    fresh->SetContactDistance(this->Filter->GetContactDistance());
    fresh->SetJoinSegments(this->Filter->GetJoinSegments());
    fresh->SetClassify(this->Filter->GetClassify());
    fresh->Update();
    for (int port = 0; port < 4; ++port)
    {
      vtkPolyData* own = this->Filter->GetOutput(port);
      vtkPolyData* other = fresh->GetOutput(port);
      const bool isSame = port < 2
        ? RelevoIsSameMesh(own, other)
        : IsSameArray(own, other, "Contact") && IsSameArray(own, other, "Distance");
      if (!isSame)
      {
        this->Error = "a new filter has another output " + std::to_string(port);
      }
    }
  }

  Dice& D;
  std::string Error;
  RelevoFuzz::RecipeCalls Recipe;
  vtkNew<vtkSurfaceIntersectionFilter> Filter;
  vtkSmartPointer<vtkPolyData> Meshes[2];
};
}

RELEVO_FUZZ_TARGET(Machine)

int TestFuzzIntersection(int, char*[])
{
  RelevoCheck check;
  int calls = 0;
  CHECK_EQUAL(RelevoFuzz::Run<Machine>(1500, 40, calls), 0);
  std::cout << calls << " calls\n";
  return check.GetResult();
}
