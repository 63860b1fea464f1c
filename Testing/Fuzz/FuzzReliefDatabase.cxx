// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Databases of reliefs: the table and, after the first null byte, the file of a relief.
#include "RelevoFuzz.h"
#include "RelevoFuzzFolder.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkReliefWarper.h"

#include <algorithm>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
  static const RelevoFuzzFolder folder;
  vtkObject::GlobalWarningDisplayOff();
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  const size_t end = std::min(text.find('\0'), size);
  folder.Write("data.csv", text.substr(0, end));
  folder.Write("r.vti", end < size ? text.substr(end + 1) : "");
  vtkNew<vtkReliefDatabaseReader> reader;
  reader->CanReadFile(folder.GetPath().c_str());
  reader->SetFileName(folder.GetPath().c_str());
  reader->Update();
  vtkMultiBlockDataSet* blocks = reader->GetOutput();
  for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
  {
    auto* image = vtkImageData::SafeDownCast(blocks->GetBlock(i));
    if (image && image->GetNumberOfPoints() <= 4096)
    {
      vtkNew<vtkReliefWarper> warper;
      warper->SetInputData(image);
      warper->SetCamera(vtkNew<vtkCamera>());
      warper->Update();
    }
  }
  return 0;
}
