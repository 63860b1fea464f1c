// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that a volume follows changes of its data and does not affect selections.
#include "RelevoCheck.h"
#include "RelevoVolumeScene.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
void ChangeValues(vtkUnstructuredGrid* mesh)
{
  vtkDataArray* values = mesh->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 1.0 - values->GetComponent(i, 0));
  }
  values->Modified();
}

// Data may also change in a block, which its composite data set does not report.
void TestData(RelevoCheck& check)
{
  const auto mesh = MakeTetrahedra(3, GetLinearField);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  for (vtkDataObject* input :
    { static_cast<vtkDataObject*>(mesh), static_cast<vtkDataObject*>(blocks) })
  {
    RelevoVolumeScene scene(input, MakeLinearProperty(), 80, 60);
    const auto before = scene.Draw();
    ChangeValues(mesh);
    const auto after = scene.Draw();
    CHECK_GREATER(FindLargestDifference(before, after), 0.05);
    CHECK_LESS_EQUAL(scene.Compare(), 1.0);
    CHECK_EQUAL(scene.GetMapper()->GetNumberOfBufferBuilds(), 2);
  }
}

// A volume cannot be selected and hides no selectable prop.
void TestSelection(RelevoCheck& check)
{
  RelevoVolumeScene scene(MakeTetrahedra(3, GetLinearField), MakeLinearProperty(), 80, 80);
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(0.3, 0.7, 0.3, 0.7, 0.3, 0.7);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.GetRenderer()->AddActor(actor);
  scene.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.GetRenderer());
  selector->SetArea(0, 0, 79, 79);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const auto with = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  scene.GetVolume()->VisibilityOff();
  const auto without = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  CHECK_EQUAL(with->GetNumberOfNodes(), 1);
  CHECK_EQUAL(without->GetNumberOfNodes(), 1);
  if (with->GetNumberOfNodes() == 1 && without->GetNumberOfNodes() == 1)
  {
    CHECK_EQUAL(with->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()), actor);
    CHECK_EQUAL(with->GetNode(0)->GetSelectionList()->GetNumberOfTuples(),
      without->GetNode(0)->GetSelectionList()->GetNumberOfTuples());
  }
}
}

int TestGPUUnstructuredGridVolumeMapperChanges(int, char*[])
{
  RelevoCheck check;
  TestData(check);
  TestSelection(check);
  return check.GetResult();
}
