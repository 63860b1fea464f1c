// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Incomplete databases: the error says what is missing, and the rest is read.
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoReliefFiles.h"
#include "RelevoReliefs.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkReliefDatabaseWriter.h"
#include "vtkXMLImageDataWriter.h"

namespace
{
vtkSmartPointer<vtkImageData> MakeRelief()
{
  return RelevoMakeRelief(30, 20, relevo::ReliefProjection::Parallel, relevo::dmat4(1.0),
    [](int column, int row) { return column * row % 7; });
}

void WriteDatabase(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeRelief());
  blocks->SetBlock(1, MakeRelief());
  vtkNew<vtkReliefDatabaseWriter> writer;
  writer->SetInputData(blocks);
  writer->SetFileName(folder.c_str());
  CHECK(writer->Write() == 1);
}

// The error, and whether the second relief was read all the same.
void ExpectError(RelevoCheck& check, const std::string& folder, const char* words)
{
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK(errors.Said(words));
  CHECK(reader->GetOutput()->GetNumberOfBlocks() == 2);
  CHECK(!RelevoGetImage(reader->GetOutput(), 0) && RelevoGetImage(reader->GetOutput(), 1));
  WriteDatabase(check, folder);
}

void TestRows(RelevoCheck& check, const std::string& folder)
{
  WriteDatabase(check, folder);
  const std::string relief = folder + "/relief_0000.vti";
  RelevoRemoveFile(relief);
  ExpectError(check, folder, "data.csv, line 2: relief_0000.vti: the file does not exist.");
  RelevoWriteFile(relief, "no relief");
  ExpectError(check, folder, "line 2: relief_0000.vti: it is no VTK XML file of image data.");
  const std::string whole = RelevoReadFile(relief);
  for (double share : { 0.3, 0.9 })
  {
    RelevoWriteFile(relief, whole.substr(0, static_cast<std::size_t>(share * whole.size())));
    ExpectError(check, folder, "line 2: relief_0000.vti: the file is damaged.");
  }
  vtkNew<vtkXMLImageDataWriter> image;
  image->SetInputData(RelevoMakeImage(3, 2, VTK_FLOAT, [](int, int) { return 1.0; }));
  image->SetFileName(relief.c_str());
  image->Write();
  ExpectError(check, folder, "line 2: relief_0000.vti: A relief needs the point array 'Color'");
  RelevoWriteFile(folder + "/data.csv", "name,FILE\nleft\nright,relief_0001.vti\n");
  ExpectError(check, folder, "data.csv, line 2: 1 fields for 2 columns.");
  RelevoWriteFile(folder + "/data.csv", "name,FILE\nleft,left.png\nright,relief_0001.vti\n");
  ExpectError(check, folder, "line 2: no column FILE has the name of a .vti file.");
}

void TestTables(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  RelevoErrors executive(reader->GetExecutive());
  CHECK(reader->GetExecutive()->Update() == 0);
  CHECK(errors.Said("There is no file name: call SetFileName()."));
  CHECK(reader->CanReadFile(nullptr) == 0 && reader->CanReadFile("") == 0);
  RelevoRemoveFile(folder + "/data.csv");
  for (const char* text : { "", "\n\n" })
  {
    CHECK(reader->CanReadFile(folder.c_str()) == 0);
    reader->SetFileName(nullptr);
    reader->SetFileName(folder.c_str());
    CHECK(reader->GetExecutive()->Update() == 0);
    CHECK(errors.Said("There is no table of reliefs, or an empty one: "));
    CHECK(reader->GetOutput()->GetNumberOfBlocks() == 0);
    RelevoWriteFile(folder + "/data.csv", text);
  }
  RelevoWriteFile(folder + "/data.csv", "a,b\n1,2\n");
  CHECK(reader->CanReadFile(folder.c_str()) == 0);
}

void TestWriter(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkReliefDatabaseWriter> writer;
  RelevoErrors errors(writer);
  writer->SetInputData(MakeRelief());
  CHECK(writer->Write() == 0 && errors.Said("There is no file name: call SetFileName()."));
  RelevoWriteFile(folder + "/file", "no folder");
  writer->SetFileName((folder + "/file").c_str());
  CHECK(writer->Write() == 0 && errors.Said("/file cannot be made."));
  writer->SetFileName(folder.c_str());
  writer->SetInputData(vtkNew<vtkMultiBlockDataSet>());
  CHECK(writer->Write() == 0 && errors.Said("There are no reliefs to write."));

  // What is no relief is left out.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  blocks->SetBlock(1, MakeRelief());
  writer->SetInputData(blocks);
  CHECK(writer->Write() == 0);
  CHECK(errors.Said("Block 1: A relief is a vtkImageData, not a vtkPolyData."));
  vtkNew<vtkReliefDatabaseReader> reader;
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfBlocks() == 1 && RelevoGetImage(reader->GetOutput(), 0));

  // A folder is in the way of each file.
  for (const char* name : { "/relief_0000.vti", "/relief_0000.png", "/data.csv" })
  {
    const std::string other = folder + "/" + std::string(name + 1) + ".in";
    RelevoMakeFolder(other + name);
    writer->SetInputData(MakeRelief());
    writer->SetFileName(other.c_str());
    CHECK(writer->Write() == 0 && errors.Said("cannot be written."));
  }
}
}

int TestReliefDatabaseErrors(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "ReliefDatabaseErrors");
  TestRows(check, folder);
  TestTables(check, folder);
  TestWriter(check, folder);
  return check.GetResult();
}
