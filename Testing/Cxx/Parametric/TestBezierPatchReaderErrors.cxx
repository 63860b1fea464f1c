// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkBezierPatchReader promises an error that names file, line and cause, and an empty output, for
// damaged files.
#include "RelevoCheck.h"
#include "RelevoFiles.h"

#include "vtkBezierPatchReader.h"
#include "vtkExecutive.h"
#include "vtkUnstructuredGrid.h"

namespace
{
const std::string Whole = "2\n1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
                          "1 1\n1 0 0\n2 0 0\n1 1 0\n2 1 0\n";

void ExpectError(RelevoCheck& check, vtkBezierPatchReader* reader, const std::string& words)
{
  RelevoErrors errors(reader);
  RelevoErrors executive(reader->GetExecutive());
  reader->Modified();
  CHECK_EQUAL(reader->GetExecutive()->Update(), 0);
  if (!errors.Said(words))
  {
    check.Fail(__FILE__, __LINE__, "no error with: " + words);
  }
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfCells(), 0);
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfPoints(), 0);
}

// Replaces one text of the file by another.
void ExpectFileError(RelevoCheck& check, const std::string& name, const std::string& from,
  const std::string& to, const std::string& words)
{
  RelevoWriteFile(name, Whole);
  vtkNew<vtkBezierPatchReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfCells(), 2);
  std::string text = Whole;
  text.replace(text.find(from), from.size(), to);
  RelevoWriteFile(name, text);
  ExpectError(check, reader, name + ", " + words);
}

void TestErrors(RelevoCheck& check, const std::string& name)
{
  ExpectFileError(check, name, "2\n1", "two\n1", "line 1: 'two' is not a number of patches.");
  ExpectFileError(check, name, "2\n1", "-1\n1", "line 1: '-1' is not a number of patches.");
  ExpectFileError(check, name, "2\n1", "1.5\n1", "line 1: '1.5' is not a number of patches.");
  ExpectFileError(
    check, name, "2\n1", "99999999999\n1", "line 1: '99999999999' is not a number of");
  ExpectFileError(check, name, "2\n1", "3\n1", "line 12: the file ends too early.");
  ExpectFileError(check, name, "2\n1", "1\n1", "line 7: there are more values than");
  ExpectFileError(
    check, name, "1 1\n1 0 0\n2", "9 1\n1 0 0\n2", "line 7: '9' is not a degree from 1 to 8.");
  ExpectFileError(
    check, name, "1 1\n1 0 0\n2", "1 0\n1 0 0\n2", "line 7: '0' is not a degree from 1 to 8.");
  ExpectFileError(
    check, name, "1 1\n1 0 0\n2", "1 x\n1 0 0\n2", "line 7: 'x' is not a degree from 1 to 8.");
  ExpectFileError(check, name, "0 1 0", "0 nan 0", "line 5: 'nan' is not a finite number.");
  ExpectFileError(check, name, "0 1 0", "0 inf 0", "line 5: 'inf' is not a finite number.");
  ExpectFileError(check, name, "0 1 0", "0 1e999 0", "line 5: '1e999' is not a finite number.");
  ExpectFileError(check, name, "0 1 0", "0 1,5 0", "line 5: '1,5' is not a finite number.");
  ExpectFileError(check, name, "0 1 0", "0 +-1 0", "line 5: '+-1' is not a finite number.");
  ExpectFileError(check, name, "0 1 0", "0 1", "line 12: the file ends too early.");
  ExpectFileError(check, name, "2 1 0\n", "2 1\n", "line 12: the file ends too early.");
  ExpectFileError(check, name, Whole, "", "line 1: the file ends too early.");
  const std::string cut = "x" + std::string(79, '7');
  ExpectFileError(
    check, name, "0 1 0", "0 " + cut + "77 0", "line 5: '" + cut + "' is not a finite");
  const std::string zeros(80, '0');
  ExpectFileError(check, name, "0 1 0", "0 " + std::string(1200, '1') + " 0",
    "line 5: '" + std::string(80, '1') + "' is not a finite number.");
  ExpectFileError(check, name, "0 1 0", "0 0." + zeros + "x 0", "line 5: '0." + zeros.substr(2));
}

void TestFiles(RelevoCheck& check, const std::string& folder)
{
  vtkNew<vtkBezierPatchReader> reader;
  ExpectError(check, reader, "There is no file name: call SetFileName().");
  CHECK_EQUAL(reader->CanReadFile(nullptr), 0);
  CHECK_EQUAL(reader->CanReadFile(""), 0);
  const std::string missing = folder + "/missing.bpt";
  reader->SetFileName(missing.c_str());
  ExpectError(check, reader, "The file cannot be read: " + missing);
  CHECK_EQUAL(reader->CanReadFile(missing.c_str()), 0);
  reader->SetFileName(folder.c_str());
  ExpectError(check, reader, folder);
  CHECK_EQUAL(reader->CanReadFile(folder.c_str()), 0);
  const std::string name = folder + "/other.bpt";
  for (const char* text : { "", "ply\n", "2\n", "2\n9 1\n", "2\n1 x\n", "-1\n1 1\n" })
  {
    CHECK_CASE(text);
    RelevoWriteFile(name, text);
    CHECK_EQUAL(reader->CanReadFile(name.c_str()), 0);
  }
  RelevoWriteFile(name, "2\n1 8\n");
  CHECK_EQUAL(reader->CanReadFile(name.c_str()), 1);
}
}

int TestBezierPatchReaderErrors(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "BezierPatchReaderErrors");
  TestErrors(check, folder + "/patches.bpt");
  TestFiles(check, folder);
  return check.GetResult();
}
