// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefDatabaseReader promises an error that names what is missing in an incomplete database,
// and reads the rest.
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoReliefFiles.h"
#include "RelevoReliefs.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkReliefDatabaseWriter.h"
#include "vtkXMLImageDataWriter.h"

#include <filesystem>

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
  CHECK_EQUAL(writer->Write(), 1);
}

// Expects the error, and the second relief in the output.
void ExpectError(RelevoCheck& check, const std::string& folder, const char* words)
{
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK(errors.Said(words));
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfBlocks(), 2);
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
  ExpectError(check, folder, "line 2: relief_0000.vti: it is not a VTK XML file of image data.");
  const std::string whole = RelevoReadFile(relief);
  for (double share : { 0.3, 0.9 })
  {
    CHECK_CASE(share);
    RelevoWriteFile(relief, whole.substr(0, static_cast<std::size_t>(share * whole.size())));
    ExpectError(check, folder, "line 2: relief_0000.vti: the file is damaged.");
  }
  // VTK's reader would crash.
  std::string unknown = whole;
  unknown[unknown.find("type=\"", unknown.find("<FieldData>")) + 6] = 'X';
  RelevoWriteFile(relief, unknown);
  ExpectError(check, folder, "line 2: relief_0000.vti: the file is damaged.");
  vtkNew<vtkXMLImageDataWriter> image;
  image->SetInputData(RelevoMakeImage(3, 2, VTK_FLOAT, [](int, int) { return 1.0; }));
  image->SetFileName(relief.c_str());
  image->Write();
  ExpectError(check, folder, "line 2: relief_0000.vti: A relief needs the point array 'Color'");
  RelevoWriteFile(folder + "/data.csv", "name,FILE\nleft\nright,relief_0001.vti\n");
  ExpectError(check, folder, "data.csv, line 2: there are 1 fields, but 2 columns.");
  RelevoWriteFile(folder + "/data.csv", "name,FILE\nleft,left.png\nright,relief_0001.vti\n");
  ExpectError(check, folder, "line 2: no FILE column has the name of a .vti file.");
}

void TestTables(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  RelevoErrors executive(reader->GetExecutive());
  CHECK_EQUAL(reader->GetExecutive()->Update(), 0);
  CHECK(errors.Said("There is no file name: call SetFileName()."));
  CHECK_EQUAL(reader->CanReadFile(nullptr), 0);
  CHECK_EQUAL(reader->CanReadFile(""), 0);
  RelevoRemoveFile(folder + "/data.csv");
  for (const char* text : { "", "\n\n" })
  {
    CHECK_CASE(text);
    CHECK_EQUAL(reader->CanReadFile(folder.c_str()), 0);
    reader->SetFileName(nullptr);
    reader->SetFileName(folder.c_str());
    CHECK_EQUAL(reader->GetExecutive()->Update(), 0);
    CHECK(errors.Said("The table of reliefs does not exist or is empty: "));
    CHECK_EQUAL(reader->GetOutput()->GetNumberOfBlocks(), 0);
    RelevoWriteFile(folder + "/data.csv", text);
  }
  RelevoWriteFile(folder + "/data.csv", "a,b\n1,2\n");
  CHECK_EQUAL(reader->CanReadFile(folder.c_str()), 0);
}

// A damaged table gives one error and an empty output.
void TestDamagedTables(RelevoCheck& check, const std::string& folder)
{
  const std::string rows = "name,FILE\nleft,relief_0000.vti\n";
  const std::pair<std::string, const char*> cases[] = {
    { "name,FILE\n", "data.csv has a header row, but no rows of reliefs." },
    { "name,FILE", "data.csv has a header row, but no rows of reliefs." },
    { rows + "\"right,relief_0001.vti\n\n", "data.csv, line 3: the quotation mark is not closed." },
    { "name,\"FILE", "data.csv, line 1: the quotation mark is not closed." },
    { rows + std::string(1, '\0') + "\n", "data.csv, byte 31 is NUL: it is not a text file." },
  };
  for (const auto& item : cases)
  {
    RelevoWriteFile(folder + "/data.csv", item.first);
    vtkNew<vtkReliefDatabaseReader> reader;
    RelevoErrors errors(reader);
    RelevoErrors executive(reader->GetExecutive());
    CHECK_EQUAL(reader->CanReadFile(folder.c_str()), 0);
    reader->SetFileName(folder.c_str());
    CHECK(reader->GetExecutive()->Update() == 0 && errors.Said(item.second));
    CHECK_EQUAL(reader->GetOutput()->GetNumberOfBlocks(), 0);
  }
  RelevoRemoveFile(folder + "/data.csv");
  RelevoMakeFolder(folder + "/data.csv");
  vtkNew<vtkReliefDatabaseReader> reader;
  CHECK_EQUAL(reader->CanReadFile(folder.c_str()), 0);
  RelevoRemoveFile(folder + "/data.csv");
}

// CR alone ends a line, except inside quotes.
void TestLineEnds(RelevoCheck& check, const std::string& folder)
{
  WriteDatabase(check, folder);
  RelevoWriteFile(
    folder + "/data.csv", "name,FILE\rleft,relief_0000.vti\r\r\"a\rb\",relief_0001.vti\r1,2\r");
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK(errors.Said("data.csv, line 6: no FILE column has the name of a .vti file. "
                    "1 of 3 rows cannot be read."));
  CHECK(RelevoGetImage(reader->GetOutput(), 0) && RelevoGetImage(reader->GetOutput(), 1));
}

// One error reports all rows: the first one and their number.
void TestManyRows(RelevoCheck& check, const std::string& folder)
{
  WriteDatabase(check, folder);
  std::string table = "name,FILE\nright,relief_0001.vti\n";
  for (int row = 0; row < 20000; ++row)
  {
    table += row % 2 == 0 ? "a\n" : "a,none.vti\n";
  }
  RelevoWriteFile(folder + "/data.csv", table);
  vtkNew<vtkReliefDatabaseReader> reader;
  int number = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&number);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  reader->AddObserver(vtkCommand::ErrorEvent, counter);
  RelevoErrors errors(reader);
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK_EQUAL(number, 1);
  CHECK(errors.Said(
    "data.csv, line 3: there are 1 fields, but 2 columns. 20000 of 20001 rows cannot be read."));
  CHECK(RelevoGetImage(reader->GetOutput(), 0));
}

void TestPlaces(RelevoCheck& check, const std::string& folder)
{
  WriteDatabase(check, folder);
  RelevoMakeFolder(folder + "/inner");
  const std::string absolute = std::filesystem::absolute(folder + "/relief_0000.vti").string();
  for (const std::string& name : { absolute, std::string("../ReliefDatabaseErrors/relief_0000.vti"),
         std::string("inner/../relief_0000.vti") })
  {
    CHECK_CASE(name);
    RelevoWriteFile(folder + "/data.csv", "FILE\n" + name + "\nrelief_0001.vti\n");
    ExpectError(check, folder, "data.csv, line 2: ");
    RelevoWriteFile(folder + "/data.csv", "FILE\n" + name + "\nrelief_0001.vti\n");
    ExpectError(check, folder, (name + " is outside the folder of the database.").c_str());
  }
  WriteDatabase(check, folder + "/inner/base");
  RelevoWriteFile(folder + "/data.csv", "FILE\ninner/base/relief_0000.vti\n");
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK(errors.None() && RelevoGetImage(reader->GetOutput(), 0));
}

void TestWriter(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkReliefDatabaseWriter> writer;
  RelevoErrors errors(writer);
  writer->SetInputData(MakeRelief());
  CHECK(writer->Write() == 0 && errors.Said("There is no file name: call SetFileName()."));
  const std::string file = folder + ".file";
  RelevoWriteFile(file, "no folder");
  writer->SetFileName(file.c_str());
  CHECK(writer->Write() == 0 && errors.Said(".file cannot be created."));
  RelevoRemoveFile(file);
  writer->SetFileName(folder.c_str());
  writer->SetInputData(vtkNew<vtkMultiBlockDataSet>());
  CHECK(writer->Write() == 0 && errors.Said("There are no reliefs to write."));

  // Blocks that are not reliefs are skipped.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  blocks->SetBlock(1, MakeRelief());
  writer->SetInputData(blocks);
  CHECK_EQUAL(writer->Write(), 0);
  CHECK(errors.Said("Block 1: A relief must be a vtkImageData, not a vtkPolyData."));
  vtkNew<vtkReliefDatabaseReader> reader;
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfBlocks() == 1 && RelevoGetImage(reader->GetOutput(), 0));

  // A folder with the name of each file prevents writing it.
  for (const char* name : { "/relief_0000.vti", "/relief_0000.png", "/data.csv" })
  {
    CHECK_CASE(name);
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
  TestDamagedTables(check, folder);
  RelevoMakeFolder(argc, argv, "ReliefDatabaseErrors");
  TestLineEnds(check, folder);
  TestManyRows(check, folder);
  TestPlaces(check, folder);
  TestWriter(check, RelevoMakeFolder(argc, argv, "ReliefDatabaseErrors"));
  return check.GetResult();
}
