// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   atomic files written by VTK's writers
 *
 * VTK's writers ignore some errors of full disks. A check of the written file is therefore required
 * for each writer.
 */
#ifndef WriteFile_h
#define WriteFile_h

#include "Checks/ErrorCollector.h"
#include "Files/AtomicFile.h"
#include "RelevoFiltersCoreModule.h" // for export macro
#include "vtkErrorCode.h"
#include "vtkExecutive.h"

#include <functional>
#include <string>

namespace relevo
{
/// Whether the file with this name has the required length and form.
using FileCheck = std::function<bool(const std::string&)>;

/// Whether a file ends like a complete VTK XML file.
RELEVOFILTERSCORE_EXPORT bool IsWholeXML(const std::string& fileName);

/// The first error of a VTK writer, without VTK's prefix and with the file name that the user gave.
RELEVOFILTERSCORE_EXPORT std::string GetWriterError(
  const std::string& errors, const AtomicFile& file);

/// Run a VTK writer without printing errors, and return them.
template <typename Writer>
std::string RunWriter(Writer* writer)
{
  std::string errors;
  std::string ignored; // the executive only repeats that the writer failed
  const unsigned long tag = writer->AddObserver(vtkCommand::ErrorEvent, NewErrorCollector(errors));
  vtkExecutive* executive = writer->GetExecutive();
  const unsigned long executiveTag =
    executive->AddObserver(vtkCommand::ErrorEvent, NewErrorCollector(ignored));
  writer->Write();
  writer->RemoveObserver(tag);
  executive->RemoveObserver(executiveTag);
  return errors.empty() && writer->GetErrorCode() != 0
    ? vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())
    : errors;
}

/// Let a VTK writer write a file and check it. Returns false and sets the file's error on failure.
template <typename Writer>
bool WriteFile(AtomicFile& file, Writer* writer, const FileCheck& isWhole)
{
  if (!file.GetError().empty())
  {
    return false;
  }
  writer->SetFileName(file.GetTemporaryName().c_str());
  const std::string errors = RunWriter(writer);
  if (!errors.empty() || !isWhole(file.GetTemporaryName()))
  {
    file.Fail(GetWriterError(errors, file));
  }
  return file.GetError().empty();
}

/// Write a file as above and replace the old one. Returns the error, or "".
template <typename Writer>
std::string WriteFile(const std::string& fileName, Writer* writer, const FileCheck& isWhole)
{
  AtomicFile file(fileName);
  WriteFile(file, writer, isWhole);
  file.Commit();
  return file.GetError();
}

/// Write the memory result of a vtkPNGWriter to a file, because libpng prints file errors.
template <typename Writer>
bool WritePNG(AtomicFile& file, Writer* writer)
{
  if (!file.GetError().empty())
  {
    return false;
  }
  writer->WriteToMemoryOn();
  const std::string errors = RunWriter(writer);
  auto* bytes = writer->GetResult();
  if (!errors.empty() || !bytes || bytes->GetNumberOfValues() == 0)
  {
    file.Fail(errors.empty() ? "the image has no pixels" : GetWriterError(errors, file));
    return false;
  }
  return file.Append({ reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) });
}
}

#endif
