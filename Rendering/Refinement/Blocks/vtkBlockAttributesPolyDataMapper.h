// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBlockAttributesPolyDataMapper
 * @brief   visibility, colour, opacity and pickability of the blocks of a composite input
 *
 * Provides the methods of vtkCompositePolyDataMapper and vtkCompositePolyDataMapper2 that set how
 * the blocks of a composite data set look, with the same names and meaning. A block is identified
 * by its flat index, or it is a key of a vtkCompositeDataDisplayAttributes. A block without a value
 * inherits it from its parent block and finally from the actor. A colour replaces the actor's
 * ambient and diffuse colour and the colours of scalars; an opacity replaces the actor's. Invisible
 * blocks are not part of the bounds. Blocks that are not pickable are drawn, but neither hardware
 * selection nor VTK's pickers find them.
 *
 * Changes take effect in the next frame and do not rebuild buffers or shaders.
 *
 * There are three differences from VTK. The methods work before SetCompositeDataDisplayAttributes()
 * has been called. Blocks without a value are returned as visible, white and of opacity 1. A block
 * with its own opacity of 1 is drawn as opaque even if the actor is translucent.
 *
 * This class is abstract and has no New(); vtkAdaptiveRefinementMapper derives from it.
 *
 * @sa vtkAdaptiveRefinementMapper vtkCompositeDataDisplayAttributes
 */
#ifndef vtkBlockAttributesPolyDataMapper_h
#define vtkBlockAttributesPolyDataMapper_h

#include "RelevoRenderingRefinementModule.h" // for export macro
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h" // for members
#include "vtkTimeStamp.h"    // for members

#include <memory> // for DisplayAttributes
#include <set>    // for MissingAnchors
#include <string> // for MissingAnchors

class vtkCompositeDataDisplayAttributes;

namespace relevo
{
struct BlockAttributes;
}

class RELEVORENDERINGREFINEMENT_EXPORT vtkBlockAttributesPolyDataMapper
  : public vtkOpenGLPolyDataMapper
{
public:
  vtkTypeMacro(vtkBlockAttributesPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the display attributes of blocks; none by default. The methods below read and write them,
   * and create them if necessary. Set pickability directly on them (SetBlockPickability()).
   */
  void SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes* attributes);
  vtkCompositeDataDisplayAttributes* GetCompositeDataDisplayAttributes();
  //@}

  //@{
  /**
   * Set whether a block is drawn, by its flat index: 0 is the input itself; its blocks follow in
   * depth-first order. The input must be up to date (Update()). An index that the input does not
   * have is an error and changes nothing.
   */
  void SetBlockVisibility(unsigned int index, bool visible);
  bool GetBlockVisibility(unsigned int index);
  void RemoveBlockVisibility(unsigned int index);
  void RemoveBlockVisibilities();
  //@}

  //@{
  /**
   * Set the colour of a block, by its flat index: red, green and blue, in [0, 1]. A value out of
   * range is an error and changes nothing.
   */
  void SetBlockColor(unsigned int index, const double color[3]);
  void SetBlockColor(unsigned int index, double r, double g, double b)
  {
    const double color[3] = { r, g, b };
    this->SetBlockColor(index, color);
  }
  double* GetBlockColor(unsigned int index) VTK_SIZEHINT(3);
  void GetBlockColor(unsigned int index, double color[3]);
  void RemoveBlockColor(unsigned int index);
  void RemoveBlockColors();
  //@}

  //@{
  /**
   * Set the opacity of a block, by its flat index, in [0, 1]. A value out of range is an error and
   * changes nothing.
   */
  void SetBlockOpacity(unsigned int index, double opacity);
  double GetBlockOpacity(unsigned int index);
  void RemoveBlockOpacity(unsigned int index);
  void RemoveBlockOpacities();
  //@}

  /**
   * Includes the modification time of the attributes.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Set the modification time. VTK rebuilds its data on the GPU, as after VTK's own setters.
   */
  void Modified() override;

  using vtkOpenGLPolyDataMapper::MapScalars;
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;

protected:
  vtkBlockAttributesPolyDataMapper();
  ~vtkBlockAttributesPolyDataMapper() override;

  //@{
  /**
   * VTK's mapper compares GetMTime() with the time at which it built buffers, textures and shaders.
   * Settings that these do not depend on must not cause a rebuild. While VTK compares, GetMTime()
   * therefore returns GetBuildMTime(): the time of the last Modified(), or of the last change of
   * the lookup table or clipping planes. Setters whose value is read in every frame call
   * SettingModified() instead of Modified(). SetLive() does so if the value changes.
   * GetMeshBuildMTime() excludes the lookup table, on which only colours depend.
   */
  void SettingModified();
  template <typename Value>
  void SetLive(Value& setting, const Value& value)
  {
    if (setting != value)
    {
      setting = value;
      this->SettingModified();
    }
  }
  vtkMTimeType GetBuildMTime() const;
  vtkMTimeType GetMeshBuildMTime() const;
  vtkTimeStamp BuildTime; // of the last Modified()
  bool IsAskedByVTK() const { return this->NumberOfQuestions > 0; }
  bool GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  void BuildBufferObjects(vtkRenderer* ren, vtkActor* act) override;
  bool GetNeedToRebuildShaders(vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;
  //@}

  void ReplaceShaderColor(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* ren, vtkActor* act) override;
  void SetPropertyShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act) override;

  /**
   * Update the mappers of the blocks of a composite input, one for each block.
   */
  virtual void UpdateBlocks() = 0;

  //@{
  /**
   * The display attributes of the data set that this mapper draws. If the mapper draws a block, the
   * mapper of the composite input sets them.
   */
  const relevo::BlockAttributes& GetBlockAttributes();
  void SetBlockAttributes(const relevo::BlockAttributes& attributes);
  //@}

  /**
   * The anchors that VTK's source lacks in the shaders being built; see relevo::ShaderText.
   */
  std::set<std::string> MissingAnchors;

  /// Return the input itself, although pickers get another data object.
  vtkDataObject* GetTrueInput();

private:
  vtkBlockAttributesPolyDataMapper(const vtkBlockAttributesPolyDataMapper&) = delete;
  void operator=(const vtkBlockAttributesPolyDataMapper&) = delete;

  vtkDataObject* FindBlock(unsigned int index);
  /// Create the attributes and return the block. If there is no block with this index, report an
  /// error and return nullptr.
  vtkDataObject* FindBlockToSet(unsigned int index);

  vtkSmartPointer<vtkCompositeDataDisplayAttributes> CompositeAttributes;
  std::unique_ptr<relevo::BlockAttributes> DisplayAttributes;
  double ColorResult[3] = { 1.0, 1.0, 1.0 };

  class Question;
  int NumberOfQuestions = 0; // of VTK's comparisons that are in progress
};

#endif
