// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceIntersectionFilter.h"

#include "Changes/LatestTime.h"
#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Compatibility/VTKCompatibility.h"
#include "Contact/CellContacts.h"
#include "Curves/CurveOutputs.h"
#include "Mesh/CurvedSurface.h"
#include "Mesh/Motion.h"
#include "Mesh/MovedSurface.h"
#include "Pairs/CellPairs.h"
#include "vtkAdaptiveRefinement.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkSurfaceIntersectionFilter);

namespace
{
void EmptyOutputs(vtkInformationVector* outputVector)
{
  for (int port = 0; port < 4; ++port)
  {
    vtkPolyData::GetData(outputVector, port)->Initialize();
  }
}
}

struct vtkSurfaceIntersectionFilter::Internals
{
  Internals()
    : Sides{ &this->Own[0], &this->Own[1] }
  {
  }

  relevo::MovedSurface Own[2];
  std::shared_ptr<relevo::MovedSurface> Shared[2];
  relevo::MovedSurface* Sides[2]; // each is one of these
  relevo::CurvedSurface Curved[2];
  bool IsSelf = false;

  // Returns the faces of a curved surface that may intersect the other surface.
  std::vector<unsigned char> FindCandidates(int side, bool isOtherCurved) const
  {
    const relevo::DoubleBoxTree& own = this->Curved[side].GetTree();
    const relevo::DoubleBoxTree& other =
      isOtherCurved ? this->Curved[1 - side].GetTree() : this->Sides[1 - side]->GetTree();
    const auto number = static_cast<vtkIdType>(own.GetItems().size());
    std::vector<unsigned char> meet(number);
    vtkSMPTools::For(0, number,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          meet[own.GetItem(i)] = other.Intersects(own.GetBox(i));
        }
      });
    return meet;
  }

  const relevo::MovedSurface& GetSecond() const { return *this->Sides[this->IsSelf ? 0 : 1]; }
};

vtkSurfaceIntersectionFilter::vtkSurfaceIntersectionFilter()
  : Surfaces(new Internals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

vtkSurfaceIntersectionFilter::~vtkSurfaceIntersectionFilter() = default;

bool vtkSurfaceIntersectionFilter::IsInput(int input)
{
  return relevo::CheckRange(this, "Input", input, 0, 1);
}

void vtkSurfaceIntersectionFilter::SetMatrix(int input, vtkMatrix4x4* matrix)
{
  if (this->IsInput(input) && this->Matrices[input] != matrix)
  {
    this->Matrices[input] = matrix;
    this->Modified();
  }
}

vtkMatrix4x4* vtkSurfaceIntersectionFilter::GetMatrix(int input)
{
  return this->IsInput(input) ? this->Matrices[input].Get() : nullptr;
}

void vtkSurfaceIntersectionFilter::SetRefinement(int input, vtkAdaptiveRefinement* refinement)
{
  if (this->IsInput(input) && this->Refinements[input] != refinement)
  {
    this->Refinements[input] = refinement;
    this->Surfaces->Own[input].Clear(); // the refined mesh may be the next input, with other cell
                                        // ids
    this->Modified();
  }
}

vtkAdaptiveRefinement* vtkSurfaceIntersectionFilter::GetRefinement(int input)
{
  return this->IsInput(input) ? this->Refinements[input].Get() : nullptr;
}

vtkPolyData* vtkSurfaceIntersectionFilter::GetRefinedSurface(int input)
{
  const bool isCurved = this->IsInput(input) && this->Refinements[input];
  const bool isThere = input == 0 || !this->Surfaces->IsSelf;
  return isCurved && isThere ? this->Surfaces->Curved[input].GetSurface().GetTriangles() : nullptr;
}

void vtkSurfaceIntersectionFilter::ShareSurface(
  int input, std::shared_ptr<relevo::MovedSurface> surface)
{
  if (this->IsInput(input))
  {
    this->Surfaces->Sides[input] = &this->Surfaces->Own[input];
    this->Surfaces->Shared[input] = std::move(surface);
  }
}

void vtkSurfaceIntersectionFilter::SetTolerance(double tolerance)
{
  relevo::SetInRange(this, "Tolerance", this->Tolerance, tolerance, 0.0, relevo::LargestDouble);
}

void vtkSurfaceIntersectionFilter::SetContactDistance(double distance)
{
  relevo::SetInRange(
    this, "ContactDistance", this->ContactDistance, distance, 0.0, relevo::LargestDouble);
}

vtkMTimeType vtkSurfaceIntersectionFilter::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(),
    { this->Matrices[0], this->Matrices[1], this->Refinements[0], this->Refinements[1] });
}

int vtkSurfaceIntersectionFilter::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

bool vtkSurfaceIntersectionFilter::TakeInput(int side, vtkPolyData* input)
{
  relevo::Motion motion;
  std::string error = motion.Set(this->Matrices[side]);
  if (error.empty() && this->Refinements[side])
  {
    error = relevo::CheckSurface(input);
  }
  if (!error.empty())
  {
    vtkErrorMacro("Input " << side << " " << error << ".");
    return false;
  }
  if (!this->Refinements[side])
  {
    return this->TakeSurface(side, input, {}, motion);
  }
  std::string warning;
  relevo::CurvedSurface& curved = this->Surfaces->Curved[side];
  const bool isTaken = curved.Take(input, this->Refinements[side], error, warning);
  if (!warning.empty())
  {
    vtkWarningMacro("Input " << side << ": " << warning);
  }
  if (!isTaken)
  {
    vtkErrorMacro("Input " << side << ": " << error);
    return false;
  }
  curved.Move(motion);
  return true;
}

bool vtkSurfaceIntersectionFilter::TakeSurface(
  int side, vtkPolyData* mesh, const std::vector<vtkIdType>& cells, const relevo::Motion& motion)
{
  const bool isShared = !this->Refinements[side] && this->Surfaces->Shared[side];
  relevo::MovedSurface& surface =
    isShared ? *this->Surfaces->Shared[side] : this->Surfaces->Own[side];
  this->Surfaces->Sides[side] = &surface;
  std::string error;
  if (!surface.IsOf(mesh))
  {
    error = surface.Take(mesh, cells);
    this->NumberOfTreeBuilds += error.empty();
  }
  if (error.empty())
  {
    error = surface.Move(motion);
  }
  if (!error.empty())
  {
    vtkErrorMacro("Input " << side << " " << error << ".");
    return false;
  }
  if (surface.GetNumberOfFlatTriangles() > 0)
  {
    vtkWarningMacro("Input " << side << " has " << surface.GetNumberOfFlatTriangles()
                             << " triangles without an area; they are left out.");
  }
  return true;
}

bool vtkSurfaceIntersectionFilter::RefineInput(int side)
{
  if (!this->Refinements[side])
  {
    return true;
  }
  relevo::CurvedSurface& curved = this->Surfaces->Curved[side];
  const bool needsAll = this->Surfaces->IsSelf || this->Classify;
  const std::vector<unsigned char> areWanted = needsAll
    ? std::vector<unsigned char>(curved.GetTree().GetItems().size(), 1)
    : this->Surfaces->FindCandidates(side, this->Refinements[1 - side] != nullptr);
  relevo::Motion motion;
  motion.Set(this->Matrices[side]);
  const double stretch = motion.GetLargestStretch();
  // A very small stretch must not result in infinity.
  const double tolerance = std::min(this->Tolerance / stretch, relevo::LargestDouble);
  const std::pair<vtkIdType, double> warning = curved.GetSurface().Refine(areWanted, tolerance);
  if (warning.first > 0)
  {
    vtkWarningMacro("Input " << side << " deviates from its surface by up to "
                             << warning.second * stretch << ", more than Tolerance, at "
                             << warning.first
                             << " faces: raise its recipe's MaximumLevel, or Tolerance.");
  }
  vtkPolyData* triangles = curved.GetSurface().GetTriangles();
  if (triangles->GetNumberOfPolys() == 0)
  {
    vtkErrorMacro(
      "Input " << side
               << " has no refined triangles: all of them lie over missing heights, or have "
                  "points that are not finite.");
    return false;
  }
  return this->TakeSurface(side, triangles, curved.GetSurface().GetCells(), motion);
}

void vtkSurfaceIntersectionFilter::WarnOfOpenSurfaces()
{
  std::string open;
  for (int side = 0; side < 2; ++side)
  {
    if (!this->Surfaces->Sides[side]->IsClosed())
    {
      open += (open.empty() ? "input " : ", input ") + std::to_string(side);
    }
  }
  if (!open.empty())
  {
    vtkWarningMacro(
      "No cell is classified as inside a surface that is not closed: " << open << ".");
  }
}

int vtkSurfaceIntersectionFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* inputs[2] = { vtkPolyData::GetData(inputVector[0]),
    vtkPolyData::GetData(inputVector[1]) };
  EmptyOutputs(outputVector);
  bool areTaken = false;
  const auto intersect = [&]
  {
    this->Surfaces->IsSelf = !inputs[1];
    areTaken = this->TakeInput(0, inputs[0]) && (!inputs[1] || this->TakeInput(1, inputs[1])) &&
      this->RefineInput(0) && (!inputs[1] || this->RefineInput(1));
    if (areTaken && !this->Intersect(inputs, outputVector))
    {
      EmptyOutputs(outputVector);
    }
  };
  if (!relevo::FitsMemory(intersect))
  {
    EmptyOutputs(outputVector);
    for (const auto& shared : this->Surfaces->Shared)
    {
      if (shared)
      {
        shared->Clear();
      }
    }
    this->Surfaces = std::make_unique<Internals>();
    vtkErrorMacro("Not enough memory for the intersection of the inputs.");
    return 0;
  }
  return areTaken ? 1 : 0;
}

bool vtkSurfaceIntersectionFilter::Report(double progress)
{
  this->UpdateProgress(progress);
  return !relevo::IsAborted(this);
}

bool vtkSurfaceIntersectionFilter::Intersect(
  vtkPolyData* inputs[2], vtkInformationVector* outputVector)
{
  const relevo::MovedSurface& first = *this->Surfaces->Sides[0];
  const relevo::MovedSurface& second = this->Surfaces->GetSecond();
  const std::vector<relevo::IntersectingPair> pairs = relevo::FindMeetingPairs(first, second);
  if (!this->Report(0.5))
  {
    return false;
  }
  relevo::MakeCurves(first, second, pairs, this->JoinSegments,
    vtkPolyData::GetData(outputVector, 0), vtkPolyData::GetData(outputVector, 1));
  if (this->AllPairs)
  {
    relevo::AddCellPairs(
      first, second, pairs, vtkPolyData::GetData(outputVector, 0)->GetFieldData());
  }
  if (!this->Report(0.7))
  {
    return false;
  }
  const bool isSelf = this->Surfaces->IsSelf;
  const bool classifies = this->Classify && !isSelf && first.HasFaces() && second.HasFaces();
  if (classifies)
  {
    this->WarnOfOpenSurfaces();
  }
  for (int side = 0; side < (isSelf ? 1 : 2); ++side)
  {
    const relevo::MovedSurface& own = *this->Surfaces->Sides[side];
    const relevo::MovedSurface& other = *this->Surfaces->Sides[1 - side];
    relevo::CellContacts contacts(own, inputs[side]->GetNumberOfCells());
    contacts.MarkCut(pairs, side);
    if (isSelf)
    {
      contacts.MarkCut(pairs, 1);
    }
    if (classifies)
    {
      contacts.MeasureDistances(other, this->ContactDistance);
      if (other.IsClosed())
      {
        contacts.FindInside(other);
      }
    }
    vtkPolyData* output = vtkPolyData::GetData(outputVector, 2 + side);
    output->ShallowCopy(inputs[side]);
    contacts.AddArrays(output);
    if (!this->Report(side == 0 ? 0.85 : 1.0))
    {
      return false;
    }
  }
  return true;
}

void vtkSurfaceIntersectionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Matrices: " << this->Matrices[0] << " " << this->Matrices[1] << "\n";
  os << indent << "Refinements: " << this->Refinements[0] << " " << this->Refinements[1] << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "JoinSegments: " << this->JoinSegments << "\n";
  os << indent << "AllPairs: " << this->AllPairs << "\n";
  os << indent << "Classify: " << this->Classify << "\n";
  os << indent << "ContactDistance: " << this->ContactDistance << "\n";
  os << indent << "NumberOfTreeBuilds: " << this->NumberOfTreeBuilds << "\n";
}
