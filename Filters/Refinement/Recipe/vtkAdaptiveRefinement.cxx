// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRefinement.h"

#include "Changes/LatestTime.h"
#include "Checks/SettingChecks.h"
#include "vtkDepthTagMetric.h"
#include "vtkDisplacement.h"
#include "vtkObjectFactory.h"
#include "vtkRefinementPatternTable.h"
#include "vtkRefinementSurface.h"

#include <algorithm>

vtkStandardNewMacro(vtkAdaptiveRefinement);

vtkAdaptiveRefinement::vtkAdaptiveRefinement()
{
  this->SetPatternTable(nullptr);
}

vtkAdaptiveRefinement::~vtkAdaptiveRefinement() = default;

void vtkAdaptiveRefinement::SetMaximumLevel(int level)
{
  const int highest = this->PatternTable->GetHighestOfRecipes();
  const bool isTableShort = level > highest && level <= vtkRefinementPatternTable::HighestLevel;
  if (relevo::CheckRange(this, "MaximumLevel", level, 0, highest,
        isTableShort ? " The pattern table has no higher level: raise its MaximumLevel, or set "
                       "another table with SetPatternTable()."
                     : "") &&
    this->MaximumLevel != level)
  {
    this->MaximumLevel = level;
    this->Modified();
  }
}

int vtkAdaptiveRefinement::GetMaximumLevel()
{
  return std::min(this->MaximumLevel, this->PatternTable->GetHighestOfRecipes());
}

void vtkAdaptiveRefinement::SetDepthTagArrayName(const char* name)
{
  const std::string value = name ? name : "";
  if (this->DepthTagArrayName != value)
  {
    this->DepthTagArrayName = value;
    this->Modified();
  }
}

const char* vtkAdaptiveRefinement::GetDepthTagArrayName()
{
  return this->DepthTagArrayName.c_str();
}

vtkCxxSetSmartPointerMacro(vtkAdaptiveRefinement, Metric, vtkDepthTagMetric);

vtkDepthTagMetric* vtkAdaptiveRefinement::GetMetric()
{
  return this->Metric;
}

void vtkAdaptiveRefinement::SetLevelRule(int rule)
{
  relevo::SetChoice(this, "LevelRule", this->LevelRule, rule, { "PER_VERTEX", "PER_EDGE" });
}

void vtkAdaptiveRefinement::SetSegmentPolicy(int policy)
{
  relevo::SetChoice(
    this, "SegmentPolicy", this->SegmentPolicy, policy, { "POWERS_OF_TWO", "WHOLE_NUMBERS" });
}

void vtkAdaptiveRefinement::SetGeomorphing(int mode)
{
  relevo::SetChoice(this, "Geomorphing", this->Geomorphing, mode,
    { "GEOMORPHING_OFF", "GEOMORPHING_ON", "GEOMORPHING_AUTOMATIC" });
}

void vtkAdaptiveRefinement::SetLevelOffset(double levels)
{
  relevo::SetInRange(this, "LevelOffset", this->LevelOffset, levels, this->GetLevelOffsetMinValue(),
    this->GetLevelOffsetMaxValue());
}

void vtkAdaptiveRefinement::SetNoDataMagnitude(double magnitude)
{
  relevo::SetNoDataMagnitude(this, this->NoDataMagnitude, magnitude);
}

vtkCxxSetSmartPointerMacro(vtkAdaptiveRefinement, Surface, vtkRefinementSurface);

vtkRefinementSurface* vtkAdaptiveRefinement::GetSurface()
{
  return this->Surface;
}

vtkCxxSetSmartPointerMacro(vtkAdaptiveRefinement, Displacement, vtkDisplacement);

vtkDisplacement* vtkAdaptiveRefinement::GetDisplacement()
{
  return this->Displacement;
}

void vtkAdaptiveRefinement::SetPatternTable(vtkRefinementPatternTable* table)
{
  if (table && table == this->PatternTable)
  {
    return;
  }
  this->PatternTable = table;
  if (!table)
  {
    this->PatternTable = vtkRefinementPatternTable::MakeDefault();
  }
  this->Modified();
}

vtkRefinementPatternTable* vtkAdaptiveRefinement::GetPatternTable()
{
  return this->PatternTable;
}

vtkMTimeType vtkAdaptiveRefinement::GetMTime()
{
  return relevo::GetLatestTime(this->Superclass::GetMTime(),
    { this->Metric.Get(), this->Surface.Get(), this->Displacement.Get(),
      this->PatternTable.Get() });
}

void vtkAdaptiveRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->GetMaximumLevel() << "\n";
  os << indent << "DepthTagArrayName: " << this->DepthTagArrayName << "\n";
  os << indent << "LevelRule: " << this->LevelRule << "\n";
  os << indent << "LevelOffset: " << this->LevelOffset << "\n";
  os << indent << "SegmentPolicy: " << this->SegmentPolicy << "\n";
  os << indent << "Geomorphing: " << this->Geomorphing << "\n";
  os << indent << "NoDataMagnitude: " << this->NoDataMagnitude << "\n";
  os << indent << "Metric: " << this->Metric.Get() << "\n";
  os << indent << "Surface: " << this->Surface.Get() << "\n";
  os << indent << "Displacement: " << this->Displacement.Get() << "\n";
  os << indent << "PatternTable: " << this->PatternTable.Get() << "\n";
}
