// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPyramidWriter.h"

#include "Checks/SettingChecks.h"
#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#if RELEVO_HAS_GDAL
#include "Pyramid/PyramidWriter.h"
#endif

namespace
{
const char* const CompressionNames[] = { "NONE", "DEFLATE", "LZW", "ZSTD" };
}

vtkStandardNewMacro(vtkTerrainPyramidWriter);

//------------------------------------------------------------------------------
vtkTerrainPyramidWriter::vtkTerrainPyramidWriter()
  : InputFileName(nullptr)
  , FileName(nullptr)
  , Compression(DEFLATE)
  , WriteIndex(true)
  , AbortExecute(false)
  , Step(COPY)
{
}

//------------------------------------------------------------------------------
vtkTerrainPyramidWriter::~vtkTerrainPyramidWriter()
{
  delete[] this->InputFileName;
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
void vtkTerrainPyramidWriter::SetCompression(int compression)
{
  relevo::SetChoice(
    this, "Compression", this->Compression, compression, { "NONE", "DEFLATE", "LZW", "ZSTD" });
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramidWriter::Report(const std::string& error)
{
  this->ErrorMessage = error;
  vtkErrorMacro(<< error);
  return false;
}

//------------------------------------------------------------------------------
bool vtkTerrainPyramidWriter::Write()
{
  this->ErrorMessage.clear();
  this->AbortExecute = false;
  this->Step = COPY;
  if (!this->InputFileName || !this->FileName || this->InputFileName[0] == '\0' ||
    this->FileName[0] == '\0')
  {
    return this->Report(
      "There is nothing to copy: call SetInputFileName() and SetFileName() first.");
  }
#if RELEVO_HAS_GDAL
  relevo::PyramidWriter::Settings settings;
  settings.Input = this->InputFileName;
  settings.Output = this->FileName;
  settings.Compression = CompressionNames[this->Compression];
  settings.HasIndex = this->WriteIndex;
  relevo::PyramidWriter writer(settings,
    [this](relevo::PyramidWriter::Step step, double fraction)
    {
      this->Step = step == relevo::PyramidWriter::Step::Copy ? COPY : INDEX;
      this->InvokeEvent(vtkCommand::ProgressEvent, &fraction);
      return !this->AbortExecute;
    });
  std::string error;
  const relevo::PyramidWriter::Result result = writer.Write(error);
  if (result == relevo::PyramidWriter::Result::Failed)
  {
    return this->Report(error + ".");
  }
  return result == relevo::PyramidWriter::Result::Done;
#else
  static_cast<void>(CompressionNames);
  return this->Report(
    "This build of Relevo does not have GDAL. Install libgdal-dev and build again.");
#endif
}

//------------------------------------------------------------------------------
void vtkTerrainPyramidWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InputFileName: " << (this->InputFileName ? this->InputFileName : "(none)")
     << "\n";
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Compression: " << CompressionNames[this->Compression] << "\n";
  os << indent << "WriteIndex: " << this->WriteIndex << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "AbortExecute: " << this->AbortExecute << "\n";
}
