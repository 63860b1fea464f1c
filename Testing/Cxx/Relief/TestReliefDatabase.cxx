// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkReliefDatabaseWriter and vtkReliefDatabaseReader promise that reliefs are read back bit for
// bit and that the table follows Cinema's Spec D.
#include "Data/Relief.h"
#include "RelevoCheck.h"
#include "RelevoFiles.h"
#include "RelevoReliefFiles.h"
#include "RelevoReliefs.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkReliefDatabaseReader.h"
#include "vtkReliefDatabaseWriter.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstring>

namespace
{
using relevo::ReliefProjection;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

bool AreSame(vtkFieldData* one, vtkFieldData* other)
{
  bool isSame = one->GetNumberOfArrays() == other->GetNumberOfArrays();
  for (int i = 0; isSame && i < one->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* a = one->GetAbstractArray(i);
    vtkAbstractArray* b = other->GetAbstractArray(a->GetName());
    isSame = b && a->GetDataType() == b->GetDataType() &&
      a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
      a->GetNumberOfTuples() == b->GetNumberOfTuples();
    if (isSame && vtkDataArray::SafeDownCast(a))
    {
      isSame = std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
                 a->GetNumberOfValues() * a->GetDataTypeSize()) == 0;
    }
    else if (isSame)
    {
      isSame = a->GetVariantValue(0).ToString() == b->GetVariantValue(0).ToString();
    }
  }
  return isSame;
}

bool AreSame(vtkImageData* one, vtkImageData* other)
{
  return one && other && std::equal(one->GetExtent(), one->GetExtent() + 6, other->GetExtent()) &&
    AreSame(one->GetPointData(), other->GetPointData()) &&
    AreSame(one->GetFieldData(), other->GetFieldData());
}

template <class ArrayType, class ValueType>
void AddField(vtkImageData* image, const char* name, const ValueType& value)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->InsertNextValue(value);
  image->GetFieldData()->AddArray(array);
}

// Two reliefs and one in a nested block, with all arrays that reliefs may have.
vtkSmartPointer<vtkMultiBlockDataSet> MakeReliefs()
{
  const auto depth = [](int column, int row)
  { return column == 1 ? NaN : 1.0 / 3.0 + column + 0.1 * row; };
  const relevo::dmat4 turned = RelevoPinhole(5, 4, 1.0 / 3.0);
  const auto left = RelevoMakeRelief(5, 4, ReliefProjection::Perspective, turned, depth);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(20);
  normals->Fill(0.1f);
  left->GetPointData()->SetNormals(normals);
  AddField<vtkDoubleArray>(left, "time", 0.1);
  AddField<vtkStringArray>(left, "kind", "a \"quoted\", long\nword");
  const auto right = RelevoMakeRelief(
    1, 6, ReliefProjection::Parallel, relevo::dmat4(2.0), [](int, int row) { return row; });
  AddField<vtkDoubleArray>(right, "FILE_none", 1.0);

  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, left);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "left, with \"quotes\"");
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, right);
  blocks->SetBlock(2, inner);
  return blocks;
}

const char* GetName(vtkMultiBlockDataSet* blocks, unsigned int block)
{
  return blocks->HasMetaData(block) ? blocks->GetMetaData(block)->Get(vtkCompositeDataSet::NAME())
                                    : nullptr;
}

void TestRoundTrip(RelevoCheck& check, const std::string& folder)
{
  const auto reliefs = MakeReliefs();
  vtkNew<vtkReliefDatabaseWriter> writer;
  RelevoErrors errors(writer);
  writer->SetInputData(reliefs);
  writer->SetFileName(folder.c_str());
  CHECK(writer->Write() == 1 && errors.None());

  vtkNew<vtkReliefDatabaseReader> reader;
  RelevoErrors readerErrors(reader);
  for (const std::string& name : { folder, folder + "/data.csv" })
  {
    CHECK_CASE(name);
    CHECK_EQUAL(reader->CanReadFile(name.c_str()), 1);
    reader->SetFileName(name.c_str());
    reader->Update();
    vtkMultiBlockDataSet* output = reader->GetOutput();
    if (CHECK_EQUAL(output->GetNumberOfBlocks(), 2))
    {
      auto* left = vtkImageData::SafeDownCast(output->GetBlock(0));
      auto* right = vtkImageData::SafeDownCast(output->GetBlock(1));
      CHECK(AreSame(left, vtkImageData::SafeDownCast(reliefs->GetBlock(0))));
      CHECK(AreSame(right, RelevoGetImage(reliefs->GetBlock(2), 0)));
      CHECK_EQUAL(GetName(output, 0), std::string("left, with \"quotes\""));
      CHECK(!GetName(output, 1));
    }
    CHECK(readerErrors.None());
  }
}

void TestTable(RelevoCheck& check, const std::string& folder)
{
  const std::string expected =
    "name,projection,columns,rows,valid,position_x,position_y,position_z,direction_x,direction_y,"
    "direction_z,up_x,up_y,up_z,time,kind,FILE,FILE_image\n"
    "\"left, with \"\"quotes\"\"\",1,5,4,0.8,0,0,0,0,0,1,0,1,0,0.1,\"a \"\"quoted\"\", "
    "long\nword\","
    "relief_0000.vti,relief_0000.png\n"
    ",0,1,6,1,0,2.5,0,0,0,1,0,1,0,,,relief_0001.vti,relief_0001.png\n";
  const std::string table = RelevoReadFile(folder + "/data.csv");
  if (!CHECK_EQUAL(table, expected))
  {
    std::cerr << table;
  }
  vtkNew<vtkPNGReader> picture;
  picture->SetFileName((folder + "/relief_0000.png").c_str());
  picture->Update();
  const auto reliefs = MakeReliefs();
  vtkDataArray* colors = RelevoGetImage(reliefs, 0)->GetPointData()->GetArray("Color");
  vtkDataArray* seen = picture->GetOutput()->GetPointData()->GetScalars();
  CHECK_EQUAL(seen->GetNumberOfTuples(), 20);
  CHECK_EQUAL(std::memcmp(seen->GetVoidPointer(0), colors->GetVoidPointer(0), 60), 0);
}

// One relief without colours replaces the previous database.
void TestImage(RelevoCheck& check, const std::string& folder)
{
  const auto reliefs = MakeReliefs();
  vtkNew<vtkReliefDatabaseWriter> writer;
  writer->SetInputData(reliefs->GetBlock(0));
  writer->SetFileName((folder + "/data.csv").c_str());
  writer->WriteImagesOff();
  CHECK_EQUAL(writer->Write(), 1);
  CHECK_EQUAL(RelevoReadFile(folder + "/data.csv").find("FILE_image"), std::string::npos);
  vtkNew<vtkReliefDatabaseReader> reader;
  reader->SetFileName(folder.c_str());
  reader->Update();
  CHECK_EQUAL(reader->GetOutput()->GetNumberOfBlocks(), 1);
  CHECK(AreSame(RelevoGetImage(reader->GetOutput(), 0), RelevoGetImage(reliefs, 0)));
}

// Tables of other programs: line ends, quotes, a byte order mark, and other FILE columns.
void TestTables(RelevoCheck& check, const std::string& folder)
{
  const std::string tables[] = { "FILE\nrelief_0000.vti",
    "\xEF\xBB\xBFphi,name,FILE_image,FILE\r\n\r\n-90,\"a\r\nb\",x.png,\"relief_0000.vti\"\r\n",
    "FILE,name\nrelief_0000.VTI.png,x\nrelief_0000.vti,\n" };
  const int blocks[] = { 1, 1, 2 };
  for (int i = 0; i < 3; ++i)
  {
    RelevoWriteFile(folder + "/data.csv", tables[i]);
    vtkNew<vtkReliefDatabaseReader> reader;
    RelevoErrors errors(reader);
    CHECK_EQUAL(reader->CanReadFile(folder.c_str()), 1);
    reader->SetFileName(folder.c_str());
    reader->Update();
    CHECK_EQUAL(static_cast<int>(reader->GetOutput()->GetNumberOfBlocks()), blocks[i]);
    CHECK(RelevoGetImage(reader->GetOutput(), blocks[i] - 1));
    CHECK(i == 2 ? errors.Said("data.csv, line 2: no FILE column has the name of a .vti file")
                 : errors.None());
    CHECK(i != 1 || GetName(reader->GetOutput(), 0) == std::string("a\r\nb"));
  }
}
}

int TestReliefDatabase(int argc, char* argv[])
{
  RelevoCheck check;
  const std::string folder = RelevoMakeFolder(argc, argv, "ReliefDatabase");
  TestRoundTrip(check, folder);
  TestTable(check, folder);
  TestImage(check, folder);
  TestTables(check, folder);
  return check.GetResult();
}
