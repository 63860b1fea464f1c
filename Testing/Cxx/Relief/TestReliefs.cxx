// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves which reliefs are found in images and composite data sets, and which blocks are reported
// as errors.
#include "Data/Reliefs.h"
#include "RelevoCheck.h"
#include "RelevoReliefs.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"

namespace
{
using relevo::ReliefBlock;

vtkSmartPointer<vtkImageData> MakeRelief(int width)
{
  return RelevoMakeRelief(
    width, 1, relevo::ReliefProjection::Parallel, relevo::dmat4(1.0), [](int, int) { return 1.0; });
}

void TestImage(RelevoCheck& check)
{
  std::vector<ReliefBlock> blocks = relevo::ReadReliefs(MakeRelief(3));
  CHECK(blocks.size() == 1 && blocks[0].Error.empty() && blocks[0].Data.GetWidth() == 3);
  CHECK(blocks[0].FlatIndex == 0 && blocks[0].Name.empty());
  blocks = relevo::ReadReliefs(vtkNew<vtkPolyData>());
  CHECK_EQUAL(blocks.size(), 1);
  CHECK_EQUAL(blocks[0].Error, "A relief must be a vtkImageData, not a vtkPolyData.");
  blocks = relevo::ReadReliefs(nullptr);
  CHECK(blocks.size() == 1 && blocks[0].Error == "There is no image.");
}

void TestBlocks(RelevoCheck& check)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, MakeRelief(2));
  inner->SetBlock(1, vtkNew<vtkPolyData>());
  inner->GetMetaData(1u)->Set(vtkCompositeDataSet::NAME(), "left");
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(1, inner); // block 0 stays empty
  outer->SetBlock(2, MakeRelief(4));
  outer->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "right");
  outer->SetBlock(3, vtkNew<vtkImageData>());

  const std::vector<ReliefBlock> blocks = relevo::ReadReliefs(outer);
  if (CHECK_EQUAL(blocks.size(), 4))
  {
    CHECK(blocks[0].FlatIndex == 3 && blocks[0].Data.GetWidth() == 2 && blocks[0].Error.empty());
    CHECK_EQUAL(
      blocks[1].Error, "Block 4 (left): A relief must be a vtkImageData, not a vtkPolyData.");
    CHECK(blocks[2].Name == "right" && blocks[2].Data.GetWidth() == 4);
    CHECK_EQUAL(blocks[3].Error.find("Block 6: The image has 0 x 0 x 0 points"), 0);
  }
  CHECK(relevo::ReadReliefs(vtkNew<vtkMultiBlockDataSet>()).empty());
}
}

int TestReliefs(int, char*[])
{
  RelevoCheck check;
  TestImage(check);
  TestBlocks(check);
  return check.GetResult();
}
