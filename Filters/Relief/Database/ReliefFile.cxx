// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Database/ReliefFile.h"

#include "Core/ErrorCollector.h"
#include "Data/Relief.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <filesystem>
#include <system_error>

namespace relevo
{
bool WriteReliefFile(const Relief& relief, const std::string& fileName)
{
  std::string errors;
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, NewErrorCollector(errors));
  writer->SetInputData(relief.GetImage());
  writer->SetFileName(fileName.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  return writer->Write() != 0 && errors.empty();
}

bool WriteReliefPicture(const Relief& relief, const std::string& fileName)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(relief.GetWidth(), relief.GetHeight(), 1);
  vtkPointData* data = relief.GetImage()->GetPointData();
  picture->GetPointData()->SetScalars(data->GetArray(Relief::GetColorName()));
  std::string errors;
  vtkNew<vtkPNGWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, NewErrorCollector(errors));
  writer->SetInputData(picture);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  return errors.empty() && writer->GetErrorCode() == vtkErrorCode::NoError;
}

vtkSmartPointer<vtkImageData> ReadReliefFile(const std::string& fileName, std::string& fault)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(fileName, ignored))
  {
    fault = "the file does not exist.";
    return nullptr;
  }
  std::string errors;
  const auto collector = NewErrorCollector(errors);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, collector);
  reader->SetParserErrorObserver(collector);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collector);
  if (!reader->CanReadFile(fileName.c_str()))
  {
    fault = "it is no VTK XML file of image data.";
    return nullptr;
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  if (!errors.empty() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    fault = "the file is damaged.";
    return nullptr;
  }
  fault = Relief().Read(reader->GetOutput());
  return fault.empty() ? reader->GetOutput() : nullptr;
}
}
