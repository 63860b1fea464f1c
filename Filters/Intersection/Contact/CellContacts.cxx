// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/CellContacts.h"

#include "Contact/InsideTest.h"
#include "Contact/SurfaceDistance.h"
#include "Mathematics/DisjointSets.h"
#include "Mesh/MovedSurface.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace relevo
{
namespace
{
constexpr double NoDistance = -1.0;
}

CellContacts::CellContacts(const MovedSurface& surface, vtkIdType numberOfCells)
  : Surface(surface)
  , Contacts(numberOfCells, Free)
{
}

bool CellContacts::IsCut(vtkIdType triangle) const
{
  return this->Contacts[this->Surface.GetCell(triangle)] == Cut;
}

void CellContacts::MarkCut(const std::vector<IntersectingPair>& pairs, int side)
{
  for (const IntersectingPair& pair : pairs)
  {
    this->Contacts[this->Surface.GetCell(pair.Triangles[side])] = Cut;
  }
}

void CellContacts::MeasureDistances(const MovedSurface& other, double nearDistance)
{
  const vtkIdType number = this->Surface.GetNumberOfTriangles();
  std::vector<double> distances(number, NoDistance);
  const SurfaceDistance distance(this->Surface, other);
  vtkSMPTools::For(0, number,
    [&](vtkIdType first, vtkIdType last)
    {
      vtkIdType nearest = -1;
      vtkIdType cell = -1;
      double square = DoubleBox::Infinity; // smallest value of the cell so far, which may have
                                           // several triangles
      for (vtkIdType t = first; t < last; ++t)
      {
        if (this->Surface.GetCell(t) != cell)
        {
          cell = this->Surface.GetCell(t);
          square = DoubleBox::Infinity;
        }
        if (this->Surface.HasArea(t) && !this->IsCut(t))
        {
          distance.Lower(t, nearest, square);
          distances[t] = distance.GetLength(square);
        }
        else if (this->Surface.HasArea(t))
        {
          distances[t] = 0.0;
        }
      }
    });
  this->Distances.assign(this->Contacts.size(), NoDistance);
  for (vtkIdType t = 0; t < number; ++t)
  {
    double& whole = this->Distances[this->Surface.GetCell(t)];
    if (this->Surface.HasArea(t))
    {
      whole = whole == NoDistance ? distances[t] : std::min(whole, distances[t]);
    }
  }
  for (std::size_t cell = 0; cell < this->Contacts.size(); ++cell)
  {
    if (this->Contacts[cell] == Free && this->Distances[cell] != NoDistance &&
      this->Distances[cell] < nearDistance)
    {
      this->Contacts[cell] = Near;
    }
  }
}

void CellContacts::FindInside(const MovedSurface& other)
{
  // Connected triangles without a cut are on the same side.
  DisjointSets parts(this->Surface.GetNumberOfPoints());
  const vtkIdType number = this->Surface.GetNumberOfTriangles();
  for (vtkIdType t = 0; t < number; ++t)
  {
    if (!this->IsCut(t) && this->Surface.HasArea(t))
    {
      const MovedSurface::Triangle& corners = this->Surface.GetCorners(t);
      parts.Unite(corners[0], corners[1]);
      parts.Unite(corners[0], corners[2]);
    }
  }
  constexpr signed char unknown = -1;
  std::vector<signed char> areInside(this->Surface.GetNumberOfPoints(), unknown);
  for (vtkIdType t = 0; t < number; ++t)
  {
    if (!this->IsCut(t) && this->Surface.HasArea(t))
    {
      const vtkIdType part = parts.Find(this->Surface.GetCorners(t)[0]);
      if (areInside[part] == unknown)
      {
        areInside[part] = IsInside(this->Surface.GetPoint(part), other);
      }
      if (areInside[part] != 0)
      {
        this->Contacts[this->Surface.GetCell(t)] = Inside;
      }
    }
  }
}

void CellContacts::AddArrays(vtkPolyData* mesh) const
{
  vtkNew<vtkUnsignedCharArray> contacts;
  contacts->SetName("Contact");
  contacts->SetNumberOfValues(static_cast<vtkIdType>(this->Contacts.size()));
  std::copy(this->Contacts.begin(), this->Contacts.end(), contacts->GetPointer(0));
  mesh->GetCellData()->AddArray(contacts);
  if (!this->Distances.empty())
  {
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("Distance");
    distances->SetNumberOfValues(static_cast<vtkIdType>(this->Distances.size()));
    std::copy(this->Distances.begin(), this->Distances.end(), distances->GetPointer(0));
    mesh->GetCellData()->AddArray(distances);
  }
}
}
