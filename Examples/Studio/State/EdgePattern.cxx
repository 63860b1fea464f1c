// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "State/EdgePattern.h"

#include "Files/ExportedMesh.h"
#include "Files/ViewerExport.h"
#include "Files/ViewerFile.h"
#include "Text/ViewerMessages.h"
#include "Text/ViewerText.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRefinementPatternTable.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
const int Highest = vtkRefinementPatternTable::HighestLevel;

double GetAngle(const PatternPlace& at, const PatternPlace& a, const PatternPlace& b)
{
  const double u[2] = { a[0] - at[0], a[1] - at[1] };
  const double v[2] = { b[0] - at[0], b[1] - at[1] };
  return vtkMath::DegreesFromRadians(
    std::abs(std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])));
}
}

//------------------------------------------------------------------------------
EdgePattern::EdgePattern()
{
  this->Table->SetMaximumLevel(Highest);
  this->Set("0,0,0");
}

//------------------------------------------------------------------------------
EdgePattern::~EdgePattern() = default;

//------------------------------------------------------------------------------
void EdgePattern::Set(const std::string& text)
{
  std::array<int, 3> levels;
  char more = 0;
  const int read =
    std::sscanf(text.c_str(), "%d,%d,%d%c", &levels[0], &levels[1], &levels[2], &more);
  if (read != 3 ||
    std::any_of(
      levels.begin(), levels.end(), [](int level) { return level < 0 || level > Highest; }))
  {
    throw ViewerError("pattern-levels needs three whole numbers from 0 to " +
      std::to_string(Highest) + ", such as 3,2,0, not '" + text + "'");
  }
  this->Levels = levels;
  this->Base = levels;
  this->Lambda = vtkRefinementPatternTable::Canonicalize(this->Base.data());
  vtkNew<vtkPolyData> pattern;
  this->Table->GetPattern(levels[0], levels[1], levels[2], pattern);
  this->Measure(pattern);
}

//------------------------------------------------------------------------------
void EdgePattern::Measure(vtkPolyData* pattern)
{
  vtkDataArray* weights = pattern->GetPointData()->GetArray("Barycentrics");
  this->Places.clear();
  for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
  {
    const double v = weights->GetComponent(i, 1);
    const double w = weights->GetComponent(i, 2);
    this->Places.push_back({ { v + 0.5 * w, std::sqrt(0.75) * w } });
  }
  this->Triangles.clear();
  this->SmallestAngle = 60.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < pattern->GetNumberOfCells(); ++cell)
  {
    pattern->GetCellPoints(cell, corners);
    std::array<int, 3> triangle;
    std::copy_n(corners->begin(), 3, triangle.begin());
    for (int i = 0; i < 3; ++i)
    {
      this->SmallestAngle = std::min(this->SmallestAngle,
        GetAngle(this->Places[triangle[i]], this->Places[triangle[(i + 1) % 3]],
          this->Places[triangle[(i + 2) % 3]]));
    }
    this->Triangles.push_back(triangle);
  }
}

//------------------------------------------------------------------------------
void EdgePattern::Save(const std::string& fileName, ViewerMessages& messages) const
{
  const std::vector<std::string> extensions = GetExportExtensions();
  if (std::find(extensions.begin(), extensions.end(), GetExtension(fileName)) == extensions.end())
  {
    throw ViewerError("cannot save the pattern as " + fileName + ": its name must end with " +
      JoinWords(extensions));
  }
  ExportedMesh mesh;
  vtkNew<vtkPolyData> pattern;
  this->Table->GetPattern(this->Levels[0], this->Levels[1], this->Levels[2], pattern);
  vtkNew<vtkPoints> points;
  for (const PatternPlace& place : this->Places)
  {
    points->InsertNextPoint(place[0], place[1], 0.0);
  }
  pattern->SetPoints(points);
  mesh.Mesh = pattern;
  mesh.UpAxis = 2;
  WriteMesh(mesh, fileName, messages);
}

//------------------------------------------------------------------------------
void EdgePattern::SaveTable(const std::string& fileName, ViewerMessages& messages)
{
  vtkNew<vtkRefinementPatternTable> table;
  messages.Observe(table);
  table->SetMaximumLevel(this->Base[0]);
  table->Write(fileName.c_str());
  messages.Check();
}
