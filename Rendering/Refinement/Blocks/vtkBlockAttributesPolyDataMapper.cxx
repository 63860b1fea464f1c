// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBlockAttributesPolyDataMapper.h"

#include "Actors/ShaderVariantKey.h"
#include "Checks/SettingChecks.h"
#include "Composite/BlockAttributes.h"
#include "Shaders/ShaderText.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkOpenGLHelper.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
using Attributes = vtkCompositeDataDisplayAttributes;

void Remove(
  Attributes* attributes, vtkDataObject* block, void (Attributes::*remove)(vtkDataObject*))
{
  if (block)
  {
    (attributes->*remove)(block);
    attributes->Modified(); // VTK 9.1 does not do this
  }
}

void RemoveAll(Attributes* attributes, void (Attributes::*remove)())
{
  if (attributes)
  {
    (attributes->*remove)();
  }
}
}

vtkBlockAttributesPolyDataMapper::vtkBlockAttributesPolyDataMapper()
  : DisplayAttributes(new relevo::BlockAttributes)
{
  this->BuildTime.Modified();
}

vtkBlockAttributesPolyDataMapper::~vtkBlockAttributesPolyDataMapper() = default;

void vtkBlockAttributesPolyDataMapper::SetCompositeDataDisplayAttributes(
  vtkCompositeDataDisplayAttributes* attributes)
{
  if (this->CompositeAttributes != attributes)
  {
    this->CompositeAttributes = attributes;
    *this->DisplayAttributes = {};
    this->SettingModified();
  }
}

vtkCompositeDataDisplayAttributes*
vtkBlockAttributesPolyDataMapper::GetCompositeDataDisplayAttributes()
{
  return this->CompositeAttributes;
}

//------------------------------------------------------------------------------
// Times

// VTK compares times as long as the object lives.
class vtkBlockAttributesPolyDataMapper::Question
{
public:
  explicit Question(vtkBlockAttributesPolyDataMapper* mapper)
    : Mapper(mapper)
  {
    ++this->Mapper->NumberOfQuestions;
  }
  ~Question() { --this->Mapper->NumberOfQuestions; }
  Question(const Question&) = delete;
  void operator=(const Question&) = delete;

private:
  vtkBlockAttributesPolyDataMapper* Mapper;
};

void vtkBlockAttributesPolyDataMapper::Modified()
{
  this->BuildTime.Modified();
  this->Superclass::Modified();
}

void vtkBlockAttributesPolyDataMapper::SettingModified()
{
  this->Superclass::Modified();
}

vtkMTimeType vtkBlockAttributesPolyDataMapper::GetBuildMTime() const
{
  const vtkMTimeType time = this->GetMeshBuildMTime();
  return this->LookupTable ? std::max(time, this->LookupTable->GetMTime()) : time;
}

vtkMTimeType vtkBlockAttributesPolyDataMapper::GetMeshBuildMTime() const
{
  const vtkMTimeType time = this->BuildTime;
  return this->ClippingPlanes ? std::max(time, this->ClippingPlanes->GetMTime()) : time;
}

vtkMTimeType vtkBlockAttributesPolyDataMapper::GetMTime()
{
  if (this->IsAskedByVTK())
  {
    return this->GetBuildMTime();
  }
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->CompositeAttributes ? std::max(time, this->CompositeAttributes->GetMTime()) : time;
}

bool vtkBlockAttributesPolyDataMapper::GetNeedToRebuildBufferObjects(
  vtkRenderer* ren, vtkActor* act)
{
  const Question question(this);
  return this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
}

void vtkBlockAttributesPolyDataMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  const Question question(this);
  this->Superclass::BuildBufferObjects(ren, act);
}

bool vtkBlockAttributesPolyDataMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  const Question question(this);
  return this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
}

vtkUnsignedCharArray* vtkBlockAttributesPolyDataMapper::MapScalars(
  vtkDataSet* input, double alpha, int& cellFlag)
{
  const Question question(this);
  return this->Superclass::MapScalars(input, alpha, cellFlag);
}

vtkDataObject* vtkBlockAttributesPolyDataMapper::GetTrueInput()
{
  return this->GetNumberOfInputConnections(0) > 0
    ? vtkDataObject::GetData(this->GetInputInformation(0, 0))
    : nullptr;
}

vtkDataObject* vtkBlockAttributesPolyDataMapper::FindBlock(unsigned int index)
{
  vtkDataObject* block = nullptr;
  if (this->CompositeAttributes)
  {
    relevo::FindBlock(this->GetTrueInput(), index, block);
  }
  return block;
}

vtkDataObject* vtkBlockAttributesPolyDataMapper::FindBlockToSet(unsigned int index)
{
  vtkDataObject* input = this->GetTrueInput();
  vtkDataObject* block = nullptr;
  if (!input || !relevo::FindBlock(input, index, block))
  {
    vtkErrorMacro("There is no block with flat index "
      << index << (input ? ": the input has fewer blocks" : ": there is no input")
      << ". Call Update() before you set attributes of blocks by their flat index.");
  }
  else if (!this->CompositeAttributes)
  {
    this->CompositeAttributes = vtkSmartPointer<vtkCompositeDataDisplayAttributes>::New();
  }
  return block;
}

//------------------------------------------------------------------------------
// By flat index

void vtkBlockAttributesPolyDataMapper::SetBlockVisibility(unsigned int index, bool visible)
{
  if (vtkDataObject* block = this->FindBlockToSet(index))
  {
    this->CompositeAttributes->SetBlockVisibility(block, visible);
  }
}

bool vtkBlockAttributesPolyDataMapper::GetBlockVisibility(unsigned int index)
{
  vtkDataObject* block = this->FindBlock(index);
  return !block || this->CompositeAttributes->GetBlockVisibility(block);
}

void vtkBlockAttributesPolyDataMapper::RemoveBlockVisibility(unsigned int index)
{
  Remove(this->CompositeAttributes, this->FindBlock(index), &Attributes::RemoveBlockVisibility);
}

void vtkBlockAttributesPolyDataMapper::RemoveBlockVisibilities()
{
  RemoveAll(this->CompositeAttributes, &Attributes::RemoveBlockVisibilities);
}

void vtkBlockAttributesPolyDataMapper::SetBlockColor(unsigned int index, const double color[3])
{
  vtkDataObject* block = this->FindBlockToSet(index);
  if (block &&
    relevo::CheckVector<3>(this, "BlockColor", { color[0], color[1], color[2] }, 0.0, 1.0))
  {
    this->CompositeAttributes->SetBlockColor(block, color);
  }
}

double* vtkBlockAttributesPolyDataMapper::GetBlockColor(unsigned int index)
{
  this->GetBlockColor(index, this->ColorResult);
  return this->ColorResult;
}

void vtkBlockAttributesPolyDataMapper::GetBlockColor(unsigned int index, double color[3])
{
  std::fill_n(color, 3, 1.0);
  if (vtkDataObject* block = this->FindBlock(index))
  {
    this->CompositeAttributes->GetBlockColor(block, color);
  }
}

void vtkBlockAttributesPolyDataMapper::RemoveBlockColor(unsigned int index)
{
  Remove(this->CompositeAttributes, this->FindBlock(index), &Attributes::RemoveBlockColor);
}

void vtkBlockAttributesPolyDataMapper::RemoveBlockColors()
{
  RemoveAll(this->CompositeAttributes, &Attributes::RemoveBlockColors);
}

void vtkBlockAttributesPolyDataMapper::SetBlockOpacity(unsigned int index, double opacity)
{
  vtkDataObject* block = this->FindBlockToSet(index);
  if (block && relevo::CheckRange(this, "BlockOpacity", opacity, 0.0, 1.0))
  {
    this->CompositeAttributes->SetBlockOpacity(block, opacity);
  }
}

double vtkBlockAttributesPolyDataMapper::GetBlockOpacity(unsigned int index)
{
  vtkDataObject* block = this->FindBlock(index);
  return block && this->CompositeAttributes->HasBlockOpacity(block)
    ? this->CompositeAttributes->GetBlockOpacity(block)
    : 1.0;
}

void vtkBlockAttributesPolyDataMapper::RemoveBlockOpacity(unsigned int index)
{
  Remove(this->CompositeAttributes, this->FindBlock(index), &Attributes::RemoveBlockOpacity);
}

void vtkBlockAttributesPolyDataMapper::RemoveBlockOpacities()
{
  RemoveAll(this->CompositeAttributes, &Attributes::RemoveBlockOpacities);
}

//------------------------------------------------------------------------------
// Drawing

const relevo::BlockAttributes& vtkBlockAttributesPolyDataMapper::GetBlockAttributes()
{
  // The mapper of a block has no attributes; its parent has set them.
  if (this->CompositeAttributes)
  {
    // The attributes of a composite input itself have no index.
    *this->DisplayAttributes = relevo::FindAttributes(
      relevo::GetAttributesOfBlocks(this->CompositeAttributes, this->GetTrueInput()), 0);
  }
  return *this->DisplayAttributes;
}

void vtkBlockAttributesPolyDataMapper::SetBlockAttributes(const relevo::BlockAttributes& attributes)
{
  *this->DisplayAttributes = attributes;
}

void vtkBlockAttributesPolyDataMapper::ReplaceShaderColor(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act)
{
  if (!ren->GetSelector())
  {
    // All programs contain this code, so that setting or removing a colour does not rebuild them.
    relevo::ShaderText fragment(shaders[vtkShader::Fragment], this->MissingAnchors);
    relevo::InsertColors(fragment, relevo::HasOwnFragments(act),
      "\n  if (relevoBlockColored)\n"
      "  {\n"
      "    ambientColor = ambientIntensity * ambientColorUniform;\n"
      "    diffuseColor = diffuseIntensity * diffuseColorUniform;\n"
      "  }\n");
    fragment.InsertBeforeMain("uniform bool relevoBlockColored;\n");
  }
  this->Superclass::ReplaceShaderColor(shaders, ren, act);
}

void vtkBlockAttributesPolyDataMapper::SetPropertyShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetPropertyShaderParameters(cellBO, ren, act);
  vtkShaderProgram* program = cellBO.Program;
  const relevo::BlockAttributes& attributes = *this->DisplayAttributes;
  const bool colored = attributes.HasColor && !this->DrawingSelection && !this->DrawingVertices;
  if (program->IsUniformUsed("relevoBlockColored"))
  {
    program->SetUniformi("relevoBlockColored", colored ? 1 : 0);
  }
  if (colored)
  {
    program->SetUniform3f("ambientColorUniform", attributes.Color);
    program->SetUniform3f("diffuseColorUniform", attributes.Color);
  }
  if (attributes.HasOpacity && !this->DrawingSelection)
  {
    program->SetUniformf("opacityUniform", static_cast<float>(attributes.Opacity));
  }
}

void vtkBlockAttributesPolyDataMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CompositeDataDisplayAttributes: " << this->CompositeAttributes.Get() << "\n";
}
