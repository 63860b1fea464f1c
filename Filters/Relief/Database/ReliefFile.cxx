// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Database/ReliefFile.h"

#include "Checks/ErrorCollector.h"
#include "Data/Relief.h"
#include "Files/WriteFile.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>

namespace relevo
{
namespace
{
// A texel has at least three bytes of colour and four of depth. A compressed byte expands to at
// most about 7000 bytes (LZMA).
constexpr double MaximumTexelsPerByte = 1000.0;

double GetNumberOfTexels(const int extent[6])
{
  double number = 1.0;
  for (int i = 0; i < 3; ++i)
  {
    number *= std::max(extent[2 * i + 1] - static_cast<double>(extent[2 * i]) + 1.0, 0.0);
  }
  return number;
}

// VTK's writers crash if memory for their buffers is insufficient. Throws std::bad_alloc before
// that.
void CheckMemory(std::size_t bytes)
{
  constexpr std::size_t buffers = 1 << 22; // including those of compression libraries
  void* volatile memory = std::malloc(buffers + bytes);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  std::free(memory);
}
}

namespace
{
// VTK's reader crashes if the type of an array of field data is missing or unknown.
class ReliefFileReader : public vtkXMLImageDataReader
{
public:
  static ReliefFileReader* New();
  vtkTypeMacro(ReliefFileReader, vtkXMLImageDataReader);

protected:
  int ReadPrimaryElement(vtkXMLDataElement* image) override
  {
    vtkXMLDataElement* data = image->FindNestedElementWithName("FieldData");
    for (int i = 0; data && i < data->GetNumberOfNestedElements(); ++i)
    {
      int type = 0;
      if (!data->GetNestedElement(i)->GetWordTypeAttribute("type", type))
      {
        vtkErrorMacro("An array of the field data has an unknown type.");
        return 0;
      }
    }
    return this->Superclass::ReadPrimaryElement(image);
  }
};
vtkStandardNewMacro(ReliefFileReader);
}

bool WriteReliefFile(const Relief& relief, AtomicFile& file)
{
  CheckMemory(0); // data is compressed in blocks
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(relief.GetImage());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  return WriteFile(file, writer.Get(), IsWholeXML);
}

bool WriteReliefPicture(const Relief& relief, AtomicFile& file)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(relief.GetWidth(), relief.GetHeight(), 1);
  vtkPointData* data = relief.GetImage()->GetPointData();
  vtkDataArray* colors = data->GetArray(Relief::GetColorName());
  CheckMemory(2 * static_cast<std::size_t>(colors->GetNumberOfValues())); // the file and a copy
  picture->GetPointData()->SetScalars(colors);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  return WritePNG(file, writer.Get());
}

vtkSmartPointer<vtkImageData> ReadReliefFile(const std::string& fileName, std::string& error)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(fileName, ignored))
  {
    error = "the file does not exist.";
    return nullptr;
  }
  std::string errors;
  const auto collector = NewErrorCollector(errors);
  vtkNew<ReliefFileReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, collector);
  reader->SetParserErrorObserver(collector);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collector);
  if (!reader->CanReadFile(fileName.c_str()))
  {
    error = "it is not a VTK XML file of image data.";
    return nullptr;
  }
  reader->SetFileName(fileName.c_str());
  reader->UpdateInformation();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  const double size = static_cast<double>(std::filesystem::file_size(fileName, ignored));
  if (errors.empty() && GetNumberOfTexels(extent) > MaximumTexelsPerByte * size)
  {
    error = "its extent has more texels than a file of its size can hold.";
    return nullptr;
  }
  try
  {
    reader->Update();
  }
  catch (const std::bad_alloc&)
  {
    error = "not enough memory.";
    return nullptr;
  }
  if (!errors.empty() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    error = "the file is damaged.";
    return nullptr;
  }
  error = Relief().Read(reader->GetOutput());
  return error.empty() ? reader->GetOutput() : nullptr;
}
}
