// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementPatternSource.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkRefinementPatternSource);

vtkRefinementPatternSource::vtkRefinementPatternSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetTable(nullptr);
}

vtkRefinementPatternSource::~vtkRefinementPatternSource() = default;

void vtkRefinementPatternSource::SetLevels(int i, int j, int k)
{
  const int levels[3] = { i, j, k };
  for (int level : levels)
  {
    if (!relevo::CheckRange(
          this, "Each of the Levels", level, 0, vtkRefinementPatternTable::HighestLevel))
    {
      return;
    }
  }
  if (!std::equal(levels, levels + 3, this->Levels))
  {
    std::copy(levels, levels + 3, this->Levels);
    this->Modified();
  }
}

void vtkRefinementPatternSource::SetTable(vtkRefinementPatternTable* table)
{
  if (table && table == this->Table)
  {
    return;
  }
  this->Table = table;
  if (!table)
  {
    this->Table = vtkRefinementPatternTable::MakeDefault();
  }
  this->Modified();
}

vtkRefinementPatternTable* vtkRefinementPatternSource::GetTable()
{
  return this->Table;
}

vtkMTimeType vtkRefinementPatternSource::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Table->GetMTime());
}

int vtkRefinementPatternSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int maximumLevel = this->Table->GetMaximumLevel();
  const int highest = *std::max_element(this->Levels, this->Levels + 3);
  if (highest > maximumLevel)
  {
    vtkErrorMacro(
      "Level " << highest << " is above the table's MaximumLevel, " << maximumLevel << ".");
    return 0;
  }
  return relevo::RequestWithinMemory(this, outputVector, "the pattern",
    [&]
    {
      return this->Table->GetPattern(
        this->Levels[0], this->Levels[1], this->Levels[2], vtkPolyData::GetData(outputVector));
    });
}

void vtkRefinementPatternSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels[0] << " " << this->Levels[1] << " " << this->Levels[2]
     << "\n";
  os << indent << "Table:\n";
  this->Table->PrintSelf(os, indent.GetNextIndent());
}
