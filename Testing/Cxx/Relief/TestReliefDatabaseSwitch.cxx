// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefDatabaseWriter promises that a folder has either the old or the complete new database,
// and that other files stay unchanged.
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoReliefFiles.h"
#include "RelevoReliefs.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkReliefDatabaseWriter.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
using Files = std::map<std::string, std::string>;

Files ReadFolder(const std::string& folder)
{
  Files files;
  for (const fs::directory_entry& file : fs::directory_iterator(folder))
  {
    files[file.path().filename().string()] = RelevoReadFile(file.path().string());
  }
  return files;
}

// `count` reliefs with this many columns.
vtkSmartPointer<vtkMultiBlockDataSet> MakeReliefs(unsigned int count, int columns)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < count; ++i)
  {
    blocks->SetBlock(i,
      RelevoMakeRelief(columns, 20, relevo::ReliefProjection::Parallel, relevo::dmat4(1.0),
        [i](int column, int row) { return std::sin(1e5 * column * row) + i; }));
  }
  return blocks;
}

bool Write(const std::string& folder, vtkMultiBlockDataSet* reliefs, std::string& error)
{
  vtkNew<vtkReliefDatabaseWriter> writer;
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputData(reliefs);
  writer->SetFileName(folder.c_str());
  const bool isWritten = writer->Write() == 1;
  error = observer->GetErrorMessage();
  return isWritten;
}

bool Has(RelevoCheck& check, const std::string& folder, unsigned int count, int columns)
{
  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors errors(reader);
  reader->SetFileName(folder.c_str());
  reader->Update();
  bool hasAll = CHECK(errors.None()) && reader->GetOutput()->GetNumberOfBlocks() == count;
  for (unsigned int i = 0; hasAll && i < count; ++i)
  {
    vtkImageData* image = RelevoGetImage(reader->GetOutput(), i);
    hasAll = image && image->GetDimensions()[0] == columns;
  }
  return hasAll;
}

// Larger and smaller databases replace the old one completely. Other files stay.
void TestSets(RelevoCheck& check, const std::string& folder)
{
  std::string error;
  for (unsigned int count : { 3, 1, 5, 5, 2 })
  {
    CHECK_CASE(count);
    CHECK(Write(folder, MakeReliefs(count, 10 + count), error));
    RelevoWriteFile(folder + "/notes.txt", "mine");
    CHECK(Has(check, folder, count, 10 + count));
    const Files files = ReadFolder(folder);
    CHECK_EQUAL(files.size(), 2 + 2 * count);
    CHECK_EQUAL(files.at("notes.txt"), "mine");
    const std::string last = "relief_000" + std::to_string(count - 1);
    CHECK_EQUAL(files.count(last + ".vti"), 1);
    CHECK_EQUAL(files.count(last + ".png"), 1);
  }
}

// After an interrupted write, numbers may not start at 0. The next write starts at 0 again.
void TestNumbers(RelevoCheck& check, const std::string& folder)
{
  std::string error;
  CHECK(Write(folder, MakeReliefs(1, 12), error));
  std::string table = RelevoReadFile(folder + "/data.csv");
  for (const std::string extension : { ".vti", ".png" })
  {
    fs::rename(folder + "/relief_0000" + extension, folder + "/relief_0007" + extension);
    RelevoWriteFile(folder + "/relief_0003" + extension, "of no row");
    table.replace(table.find("relief_0000" + extension), 11, "relief_0007");
  }
  RelevoWriteFile(folder + "/data.csv", table);
  CHECK(Has(check, folder, 1, 12));
  CHECK(Write(folder, MakeReliefs(4, 13), error) && Has(check, folder, 4, 13));
  const Files files = ReadFolder(folder);
  CHECK(files.size() == 9 && files.count("relief_0000.vti") && files.count("relief_0003.png"));
}

void TestForeignFiles(RelevoCheck& check, const std::string& folder)
{
  std::string error;
  for (const std::string name : { "data.csv", "relief_0000.vti", "a.txt", ".hidden" })
  {
    CHECK_CASE(name);
    const std::string own = folder + "/" + name + ".in";
    RelevoMakeFolder(own);
    RelevoWriteFile(own + "/" + name, "a,b\n1,2\n");
    RelevoWriteFile(own + "/z.txt", "mine");
    const Files before = ReadFolder(own);
    CHECK(!Write(own, MakeReliefs(2, 10), error) && ReadFolder(own) == before);
    CHECK_NOT_EQUAL(
      error.find("It holds " + name + ", which does not belong to a relief database."),
      std::string::npos);
  }
  // A database of images that are not reliefs.
  RelevoWriteFile(folder + "/data.csv.in/data.csv", "name,FILE\nmine,z.vti\n");
  RelevoWriteFile(folder + "/data.csv.in/z.vti", "no relief");
  const Files before = ReadFolder(folder + "/data.csv.in");
  CHECK(!Write(folder + "/data.csv.in", MakeReliefs(2, 10), error));
  CHECK_EQUAL(ReadFolder(folder + "/data.csv.in"), before);
  // A temporary file left by SIGKILL is not treated as foreign.
  const std::string left = folder + "/left";
  RelevoMakeFolder(left);
  RelevoWriteFile(left + "/.relief_0000.abcdefgh.part.vti", "half a relief");
  CHECK(Write(left, MakeReliefs(1, 10), error) && Has(check, left, 1, 10));
}

// Exit status of a process that writes with this limit for file sizes.
int WriteWithLimit(const std::string& folder, vtkMultiBlockDataSet* reliefs, rlim_t limit)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const rlimit most = { limit, limit };
    setrlimit(RLIMIT_FSIZE, &most);
    std::string error;
    const bool isWritten = Write(folder, reliefs, error);
    _exit(isWritten ? 0 : error.find("cannot be written: File too large.") < error.size() ? 7 : 8);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void TestFullDisk(RelevoCheck& check, const std::string& folder)
{
  std::string error;
  const std::string old = folder + "/old";
  CHECK(Write(old, MakeReliefs(2, 10), error));
  const Files before = ReadFolder(old);
  // Many short files with a long table, or a few large files: the limit stops either the table or a
  // file.
  const auto many = MakeReliefs(80, 1);
  const auto large = MakeReliefs(2, 400);
  const std::pair<vtkMultiBlockDataSet*, rlim_t> cases[] = { { many, 4500 }, { large, 5000 },
    { large, 1 }, { large, 25000 } };
  for (const auto& item : cases)
  {
    CHECK_EQUAL(WriteWithLimit(old, item.first, item.second), 7);
    CHECK(ReadFolder(old) == before && Has(check, old, 2, 10));
    CHECK_EQUAL(WriteWithLimit(folder + "/new", item.first, item.second), 7);
    CHECK(!fs::exists(folder + "/new"));
  }
  CHECK(WriteWithLimit(old, large, 1 << 20) == 0 && Has(check, old, 2, 400));
  CHECK(Write(old, many, error) && fs::file_size(old + "/data.csv") > 4500);
  CHECK_LESS(fs::file_size(old + "/relief_0000.vti"), 4500);
}
}

int TestReliefDatabaseSwitch(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "ReliefDatabaseSwitch");
  RelevoMakeFolder(folder + "/full");
  TestSets(check, folder + "/sets");
  TestNumbers(check, folder + "/numbers");
  TestForeignFiles(check, folder);
  TestFullDisk(check, folder + "/full");
  return check.GetResult();
}
