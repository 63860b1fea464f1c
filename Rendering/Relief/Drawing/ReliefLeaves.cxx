// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/ReliefLeaves.h"

#include "Checks/ShouldReport.h"
#include "Composite/DataLeaves.h"
#include "Data/ReliefSides.h"
#include "Drawing/PickedRelief.h"
#include "Drawing/ReliefRims.h"
#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkMath.h"

#include <algorithm>

namespace relevo
{
std::vector<ReliefPainter*> ReliefLeaf::GetPainters() const
{
  std::vector<ReliefPainter*> painters;
  for (ReliefPainter* painter : { this->Surface.Get(), this->Rims.Get() })
  {
    if (painter)
    {
      painters.push_back(painter);
    }
  }
  return painters;
}

void ReliefLeaves::Update(vtkDataObject* input, const Settings& settings, vtkWindow* window,
  const std::function<void(const std::string&)>& report)
{
  Dependencies source = GetLeafDependencies(input);
  source.Add(settings.MaximumStretch);
  source.Add(settings.HasRims);
  this->Current = settings;
  if (!this->Source.Update(source))
  {
    return;
  }
  std::vector<ReliefBlock> reliefs;
  if (input)
  {
    reliefs = ReadReliefs(input);
  }
  this->LeafMapper::Update(reliefs, window,
    [&](const ReliefBlock& relief, ReliefLeaf& leaf)
    {
      leaf.Relief = relief;
      if (ShouldReport(leaf.Error, relief.Error))
      {
        report(relief.Error);
      }
      if (!relief.Error.empty())
      {
        leaf.Source.Clear();
        return;
      }
      leaf.Surface = leaf.Surface ? leaf.Surface : vtkSmartPointer<ReliefPainter>::New();
      Dependencies own;
      own.AddObject(relief.Data.GetImage());
      own.Add(settings.MaximumStretch);
      if (leaf.Source.Update(own))
      {
        leaf.Surface->SetRelief(relief.Data, settings.MaximumStretch);
        leaf.Picked = nullptr;
      }
    });
  this->UpdateRims(window);
}

void ReliefLeaves::UpdateRims(vtkWindow* window)
{
  std::vector<ReliefLeaf*> wanted;
  Dependencies source;
  source.Add(this->Current.MaximumStretch);
  for (auto& entry : this->GetLeaves())
  {
    if (this->Current.HasRims && entry.second.Relief.Error.empty())
    {
      wanted.push_back(&entry.second);
      source.AddObject(entry.second.Relief.Data.GetImage());
    }
  }
  if (!this->RimDependencies.Update(source))
  {
    return;
  }
  std::vector<RimSource> reliefs;
  if (wanted.size() > 1)
  {
    for (ReliefLeaf* leaf : wanted)
    {
      const double stretch = std::min(this->Current.MaximumStretch, RimStretch);
      reliefs.push_back({ &leaf->Relief.Data, FindReliefSides(leaf->Relief.Data, stretch) });
    }
  }
  for (auto& entry : this->GetLeaves())
  {
    ReliefLeaf& leaf = entry.second;
    const auto place = std::find(wanted.begin(), wanted.end(), &leaf);
    vtkSmartPointer<vtkImageData> image;
    if (place != wanted.end() && !reliefs.empty())
    {
      image = MakeReliefRims(reliefs, place - wanted.begin());
    }
    Relief rims;
    if (!image || !rims.Read(image).empty())
    {
      this->Retire(leaf.Rims, window);
      leaf.Rims = nullptr;
      continue;
    }
    leaf.Rims = leaf.Rims ? leaf.Rims : vtkSmartPointer<ReliefPainter>::New();
    leaf.Rims->SetRelief(rims, this->Current.MaximumStretch);
  }
}

void ReliefLeaves::AddBounds(vtkBoundingBox& box)
{
  for (const auto& entry : this->GetLeaves())
  {
    const ReliefLeaf& leaf = entry.second;
    if (leaf.Error.empty() && vtkMath::AreBoundsInitialized(leaf.Surface->GetSurfaceBounds()))
    {
      box.AddBounds(leaf.Surface->GetSurfaceBounds());
    }
  }
}

bool ReliefLeaves::AreTranslucent()
{
  const Leaves& leaves = this->GetLeaves();
  return std::any_of(leaves.begin(), leaves.end(),
    [](const auto& entry)
    { return entry.second.Error.empty() && entry.second.Surface->IsTranslucent(); });
}

double ReliefLeaves::CountTriangles()
{
  double triangles = 0.0;
  for (const auto& entry : this->GetLeaves())
  {
    triangles += entry.second.Surface ? entry.second.Surface->GetNumberOfTriangles() : 0.0;
  }
  return triangles;
}

vtkStructuredGrid* ReliefLeaves::GetPickedSurface(unsigned int flatIndex)
{
  ReliefLeaf* leaf = this->Find(flatIndex);
  if (!leaf || !leaf->Error.empty())
  {
    return this->NoSurface;
  }
  if (!leaf->Picked)
  {
    leaf->Picked = MakePickedRelief(leaf->Relief.Data, this->Current.MaximumStretch);
  }
  return leaf->Picked;
}

vtkDataObject* ReliefLeaves::GetPicked(vtkDataObject* input)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return this->GetPickedSurface(0);
  }
  this->PickedBlocks = ReplaceLeaves(
    composite, [this](unsigned int flatIndex) { return this->GetPickedSurface(flatIndex); });
  return this->PickedBlocks;
}
}
