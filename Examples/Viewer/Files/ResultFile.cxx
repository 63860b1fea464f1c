// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/ResultFile.h"

#include "FileEnd.h"
#include "Files/MeshPoints.h"
#include "Files/ResultFormats.h"
#include "Files/ResultReader.h"
#include "Files/ViewerFile.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPointSet.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
ResultFile::ResultFile(const std::string& fileName, ViewerMessages& messages)
  : FileName(fileName)
  , Messages(messages)
{
  if (!IsMarkerFile(fileName) || !vtksys::SystemTools::FileExists(fileName))
  {
    CheckFile(fileName);
  }
  this->Guard(
    [&]
    {
      CheckFileEnd(fileName, [&](const std::string& text) { messages.Warn(text); });
      this->Reader = MakeResultReader(fileName, messages);
      this->Times = this->Reader->GetTimes();
    });
}

//------------------------------------------------------------------------------
ResultFile::~ResultFile() = default;

//------------------------------------------------------------------------------
int ResultFile::FindStep(const std::optional<double>& time) const
{
  if (!time)
  {
    return 0;
  }
  if (this->Times.empty())
  {
    throw ViewerError(this->FileName + " has no time steps");
  }
  const auto nearest = std::min_element(this->Times.begin(), this->Times.end(),
    [&](double a, double b) { return std::abs(a - *time) < std::abs(b - *time); });
  return static_cast<int>(nearest - this->Times.begin());
}

//------------------------------------------------------------------------------
void ResultFile::Read(int step, const std::function<void(vtkDataObject*)>& take)
{
  this->Guard(
    [&]
    {
      const auto data = this->Reader->Read(
        this->Times.empty() ? std::nullopt : std::make_optional(this->Times[step]));
      const auto blocks = vtkCompositeDataSet::GetDataSets(data);
      if (blocks.empty())
      {
        throw ViewerError("it has no data set with points and cells");
      }
      for (vtkDataSet* block : blocks)
      {
        if (auto* points = vtkPointSet::SafeDownCast(block))
        {
          CheckCorners(points);
        }
      }
      take(data);
    });
}

//------------------------------------------------------------------------------
void ResultFile::Guard(const std::function<void()>& work)
{
  const ReadingGuard guard({ this->FileName });
  try
  {
    this->Messages.StartReading();
    work();
    this->Messages.CheckReading();
  }
  catch (const std::exception&)
  {
    ThrowReadingError(this->FileName);
  }
}
