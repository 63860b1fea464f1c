// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/MeshColours.h"

#include "Files/ViewerFile.h"
#include "Options/Palettes.h"
#include "Text/ReadingGuard.h"
#include "Text/ViewerMessages.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName, ViewerMessages& messages)
{
  CheckFile(fileName);
  const ReadingGuard guard({ fileName });
  messages.StartReading();
  auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(fileName.c_str()));
  if (!reader)
  {
    throw ViewerError("cannot read " + fileName + ": it is not a PNG, JPEG, TIFF or BMP file");
  }
  messages.Observe(reader, "reading");
  reader->SetFileName(fileName.c_str());
  reader->Update();
  messages.CheckReading();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkScalarsToColors> MakeColours(const std::string& palette, const double range[2])
{
  if (!palette.empty())
  {
    const auto named = MakePalette(palette, { { range[0], range[1] } });
    named->SetVectorModeToMagnitude();
    return named;
  }
  const double colours[][3] = { { 0.267, 0.005, 0.329 }, { 0.229, 0.322, 0.546 },
    { 0.128, 0.567, 0.551 }, { 0.369, 0.789, 0.383 }, { 0.993, 0.906, 0.144 } };
  auto table = vtkSmartPointer<vtkColorTransferFunction>::New();
  table->SetVectorModeToMagnitude();
  for (int i = 0; i < 5; ++i)
  {
    table->AddRGBPoint(
      range[0] + 0.25 * i * (range[1] - range[0]), colours[i][0], colours[i][1], colours[i][2]);
  }
  return table;
}
