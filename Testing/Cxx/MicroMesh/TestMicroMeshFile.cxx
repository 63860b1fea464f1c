// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMicroMeshWriter and vtkMicroMeshReader promise all numbers to the bit, one clear error for
// each changed byte and for each truncated file, and the old file if writing fails.
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoMicroMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMicroMeshReader.h"
#include "vtkMicroMeshWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtk_zlib.h"

#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace RelevoMicroMeshes;

namespace
{
Mesh Read(const std::string& file, std::string& error)
{
  vtkNew<vtkMicroMeshReader> reader;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> ignored; // the executive repeats that the reader failed
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, ignored);
  reader->SetFileName(file.c_str());
  reader->Update();
  error = observer->GetErrorMessage();
  return reader->GetOutput();
}

bool Write(const std::string& file, vtkPolyData* mesh, std::string& error)
{
  vtkNew<vtkMicroMeshWriter> writer;
  vtkNew<vtkTest::ErrorObserver> observer;
  writer->AddObserver(vtkCommand::ErrorEvent, observer);
  writer->SetInputData(mesh);
  writer->SetFileName(file.c_str());
  const bool isWritten = writer->Write() == 1;
  error = observer->GetErrorMessage();
  return isWritten && error.empty();
}

bool Has(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

// An array of each type, with its extreme values.
void AddArrays(vtkPolyData* mesh)
{
  for (int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    array->SetName(array->GetClassName());
    array->SetNumberOfComponents(2);
    array->SetNumberOfTuples(mesh->GetNumberOfPoints());
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->SetComponent(i, 0, i % 3 == 0 ? array->GetDataTypeMax() : 7.0 * i);
      array->SetComponent(i, 1, i % 2 == 0 ? array->GetDataTypeMin() : 0.0);
    }
    mesh->GetPointData()->AddArray(array);
  }
  vtkNew<vtkSOADataArrayTemplate<float>> separate;
  separate->SetName("Separate");
  separate->SetNumberOfComponents(3);
  separate->SetNumberOfTuples(mesh->GetNumberOfPoints());
  separate->Fill(0.25);
  separate->SetComponent(1, 2, std::numeric_limits<double>::infinity());
  mesh->GetPointData()->SetVectors(separate);
}

std::string GetBytes(vtkDataArray* array)
{
  auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
  copy->DeepCopy(array);
  return { static_cast<const char*>(copy->GetVoidPointer(0)),
    static_cast<std::size_t>(copy->GetNumberOfValues() * copy->GetDataTypeSize()) };
}

void CheckSame(RelevoCheck& check, vtkFieldData* a, vtkFieldData* b)
{
  CHECK_EQUAL(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = a->GetArray(i);
    CHECK_CASE(std::string(array->GetName()));
    vtkDataArray* other = b->GetArray(array->GetName());
    if (CHECK(other != nullptr))
    {
      CHECK_EQUAL(array->GetDataType(), other->GetDataType());
      CHECK_EQUAL(array->GetNumberOfComponents(), other->GetNumberOfComponents());
      CHECK(GetBytes(array) == GetBytes(other));
    }
  }
}

void CheckRoundTrip(RelevoCheck& check, const std::string& folder, const Mesh& micro)
{
  const std::string file = folder + "/all.rmm";
  AddArrays(micro);
  std::string error;
  for (int most : { 127, 1023, 1024, 32767 }) // 8, 11 and 16 bits
  {
    CHECK_CASE(most);
    vtkNew<vtkShortArray> samples;
    samples->DeepCopy(micro->GetFieldData()->GetArray("MicroMeshDisplacements"));
    samples->SetValue(1, static_cast<short>(most));
    samples->SetValue(2, static_cast<short>(-most - 1));
    micro->GetFieldData()->AddArray(samples);
    CHECK(Write(file, micro, error));
    const Mesh read = Read(file, error);
    CHECK_EQUAL(error, "");
    CHECK_EQUAL(read->GetNumberOfPoints(), micro->GetNumberOfPoints());
    CHECK_EQUAL(CountDifferences(micro, read), 0);
    CheckSame(check, micro->GetPointData(), read->GetPointData());
    CheckSame(check, micro->GetCellData(), read->GetCellData());
    CheckSame(check, micro->GetFieldData(), read->GetFieldData());
    CHECK_EQUAL(read->GetPointData()->GetVectors(), read->GetPointData()->GetArray("Separate"));
    CHECK_EQUAL(read->GetPointData()->GetNormals(), read->GetPointData()->GetArray("Normals"));
  }
}

// The mesh with its triangles, and their data, in the reverse order. The file does not rely on that
// of the filter.
Mesh Reverse(vtkPolyData* micro)
{
  Mesh reversed = Mesh::New();
  reversed->DeepCopy(micro);
  const vtkIdType number = micro->GetNumberOfCells();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> corners;
  vtkCellData* data = reversed->GetCellData();
  for (vtkIdType i = number; i-- > 0;)
  {
    micro->GetCellPoints(i, corners);
    triangles->InsertNextCell(corners);
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      data->GetAbstractArray(a)->SetTuple(
        number - 1 - i, i, micro->GetCellData()->GetAbstractArray(a));
    }
  }
  reversed->SetPolys(triangles);
  return reversed;
}

void CheckSize(RelevoCheck& check, const std::string& folder, const Mesh& micro)
{
  std::string error;
  CHECK(Write(folder + "/size.rmm", micro, error));
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(micro);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetFileName((folder + "/size.vtp").c_str());
  writer->Write();
  CHECK_LESS(std::filesystem::file_size(folder + "/size.rmm"),
    0.4 * static_cast<double>(std::filesystem::file_size(folder + "/size.vtp")));
}

// The smallest micro-mesh of the test, so that each byte can be changed.
Mesh MakeSmall()
{
  const Mesh micro = Encode(Plate(4), 0.05, 1, 0.9);
  micro->GetCellData()->RemoveArray("Material");
  return micro;
}

// A file of about 300 kB: noise does not compress.
Mesh MakeLarge()
{
  const Mesh micro = MakeSmall();
  vtkNew<vtkFloatArray> noise;
  noise->SetName("Noise");
  for (int i = 0; i < 100000; ++i)
  {
    noise->InsertNextValue(static_cast<float>(std::sin(1e5 * i)));
  }
  micro->GetFieldData()->AddArray(noise);
  return micro;
}

void CheckDamage(RelevoCheck& check, const std::string& folder)
{
  const std::string file = folder + "/small.rmm";
  std::string error;
  CHECK(Write(file, MakeSmall(), error));
  const std::string whole = RelevoReadFile(file);
  CHECK_GREATER(Read(file, error)->GetNumberOfCells(), 0);
  const auto expect = [&](const std::string& bytes, const std::string& words)
  {
    RelevoWriteFile(file, bytes);
    const vtkIdType cells = Read(file, error)->GetNumberOfCells();
    return CHECK_EQUAL(cells, 0) && CHECK(Has(error, file + ": ")) && CHECK(Has(error, words));
  };
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    CHECK_CASE(i);
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ (1 << i % 8));
    if (!expect(changed, i < 8 ? "it is not an .rmm file" : "the file is damaged: "))
    {
      break;
    }
  }
  constexpr std::size_t header = 32;
  for (std::size_t size = 0; size < whole.size(); size += size < 2 * header ? 1 : 17)
  {
    CHECK_CASE(size);
    if (!expect(whole.substr(0, size), size < 8 ? "it is not an .rmm file" : "is truncated: "))
    {
      break;
    }
  }
  expect(whole + "x", "the file is damaged: it has 1 bytes too many");
  std::string newer = whole; // or older
  for (char version : { 1, 3 })
  {
    newer[8] = version;
    const auto checksum = static_cast<std::uint32_t>(
      crc32(crc32(0, nullptr, 0), reinterpret_cast<const Bytef*>(newer.data()), 28));
    for (int i = 0; i < 4; ++i)
    {
      newer[28 + i] = static_cast<char>(checksum >> 8 * i & 255);
    }
    expect(newer,
      version == 3
        ? "its format has version 3, but this Relevo reads only 2. Use a newer Relevo."
        : "its format has version 1, but this Relevo reads only 2. Encode the mesh again.");
  }
}

void CheckErrors(RelevoCheck& check, const std::string& folder)
{
  std::string error;
  CHECK_EQUAL(Read("", error)->GetNumberOfCells(), 0);
  CHECK(Has(error, "There is no file name"));
  for (const std::string& missing : { folder, folder + "/missing.rmm" })
  {
    CHECK_EQUAL(Read(missing, error)->GetNumberOfCells(), 0);
    CHECK(Has(error, missing + ": the file does not exist or cannot be read."));
  }
  const Mesh micro = MakeSmall();
  CHECK(!Write("", micro, error) && Has(error, "There is no file name"));
  CHECK(!Write(folder + "/none/a.rmm", micro, error));
  CHECK(Has(error, "a.rmm: cannot be written: the folder "));
  for (const Mesh& mesh : { Mesh::New(), Plate(4) })
  {
    CHECK(!Write(folder + "/no.rmm", mesh, error));
    CHECK(Has(error, "no.rmm: the mesh is not a micro-mesh: "));
    CHECK(!std::filesystem::exists(folder + "/no.rmm"));
  }
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  names->SetNumberOfValues(1);
  micro->GetFieldData()->AddArray(names);
  vtkNew<vtkMicroMeshWriter> writer;
  RelevoErrors errors(writer);
  writer->SetInputData(micro);
  writer->SetFileName((folder + "/names.rmm").c_str());
  CHECK_EQUAL(writer->Write(), 1);
  CHECK(errors.Warned("\"Names\" is not numeric and is left out"));
  vtkNew<vtkMicroMeshReader> reader;
  CHECK_EQUAL(reader->CanReadFile((folder + "/names.rmm").c_str()), 1);
  CHECK_EQUAL(reader->CanReadFile((folder + "/missing.rmm").c_str()), 0);
  CHECK_EQUAL(reader->CanReadFile(nullptr), 0);
  RelevoWriteFile(folder + "/text.rmm", "solid ascii");
  CHECK_EQUAL(reader->CanReadFile((folder + "/text.rmm").c_str()), 0);
}

// Whether the folder has only this file, with these bytes.
bool HasOnly(const std::string& folder, const std::string& file, const std::string& bytes)
{
  const auto begin = std::filesystem::directory_iterator(folder);
  return std::distance(begin, std::filesystem::directory_iterator()) == 1 &&
    RelevoReadFile(file) == bytes;
}

void CheckFullDisk(RelevoCheck& check, const std::string& folder, vtkPolyData* large)
{
  const std::string file = folder + "/old.rmm";
  std::string error;
  CHECK(Write(file, MakeSmall(), error));
  const std::string old = RelevoReadFile(file);
  for (rlim_t limit : { 1, 500, 20000 })
  {
    CHECK_CASE(static_cast<int>(limit));
    const pid_t child = fork();
    if (child == 0)
    {
      const rlimit most = { limit, limit };
      setrlimit(RLIMIT_FSIZE, &most);
      _exit(!Write(file, large, error) && Has(error, "cannot be written: File too large.") ? 7 : 8);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 7);
    CHECK(HasOnly(folder, file, old));
  }
}

// A process replaces a file again and again until SIGKILL ends it.
void CheckKill(RelevoCheck& check, const std::string& folder, vtkPolyData* large)
{
  const std::string file = folder + "/killed.rmm";
  const Mesh small = MakeSmall();
  std::string error;
  CHECK(Write(file, large, error));
  const std::string one = RelevoReadFile(file);
  CHECK(Write(file, small, error));
  const std::string other = RelevoReadFile(file);
  for (int i = 0; i < 10; ++i)
  {
    CHECK_CASE(i);
    int ready[2];
    CHECK_EQUAL(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0)
    {
      for (int round = 0;; ++round)
      {
        Write(file, round % 2 == 0 ? large : small.Get(), error);
        if (round == 1 && write(ready[1], "x", 1) != 1)
        {
          _exit(1);
        }
      }
    }
    char byte = 0;
    CHECK_EQUAL(read(ready[0], &byte, 1), 1);
    usleep(static_cast<useconds_t>(700 * i));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    close(ready[0]);
    close(ready[1]);
    const std::string bytes = RelevoReadFile(file);
    CHECK(bytes == one || bytes == other);
    CHECK_GREATER(Read(file, error)->GetNumberOfCells(), 0);
  }
}
}

int TestMicroMeshFile(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "MicroMeshFile");
  const Mesh micro = Encode(ReliefSphere(48, 30), 0.005);
  CheckSize(check, folder, micro);
  CheckRoundTrip(check, folder, micro);
  const Mesh plate = Encode(Plate(24), 0.02); // with sharp edges
  CheckRoundTrip(check, folder, plate);
  CheckRoundTrip(check, folder, Reverse(plate));
  CheckDamage(check, folder);
  CheckErrors(check, folder);
  const Mesh large = MakeLarge();
  RelevoMakeFolder(folder + "/full");
  CheckFullDisk(check, folder + "/full", large);
  RelevoMakeFolder(folder + "/killed");
  CheckKill(check, folder + "/killed", large);
  return check.GetResult();
}
