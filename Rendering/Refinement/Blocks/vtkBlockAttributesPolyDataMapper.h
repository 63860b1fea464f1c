// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBlockAttributesPolyDataMapper
 * @brief   visibility, colour, opacity and pickability of the blocks of a composite input
 *
 * Has the methods of vtkCompositePolyDataMapper and vtkCompositePolyDataMapper2 that choose how the
 * blocks of a composite data set look, with their names and meaning: a block is named by its flat
 * index, or is a key of a vtkCompositeDataDisplayAttributes, and what it has no value for comes
 * from the block that it is in and in the end from the actor. A colour replaces the actor's ambient
 * and diffuse colour and those of scalars, an opacity the actor's. Blocks that are not visible do
 * not count for the bounds. Blocks that are not pickable are drawn, but neither hardware selection
 * nor VTK's pickers find them.
 *
 * Changes are seen in the next frame, and cost no rebuild of buffers or shaders.
 *
 * Unlike VTK's, the methods work before SetCompositeDataDisplayAttributes() has been called; what
 * no value has been set for is visible, white and of opacity 1; and a block that is opaque by its
 * own opacity is drawn also where its actor is translucent.
 *
 * Has no New(): vtkAdaptiveRefinementMapper is one.
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
   * How blocks look; none by default. The methods below read and write it, and make one where there
   * is none. Pickability is set on it alone (SetBlockPickability()).
   */
  void SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes* attributes);
  vtkCompositeDataDisplayAttributes* GetCompositeDataDisplayAttributes();
  //@}

  //@{
  /**
   * Whether a block is drawn, by its flat index: 0 is the input itself, its blocks follow depth
   * first. The input must be up to date (Update()). Setting an index that the input does not have
   * is an error and changes nothing.
   */
  void SetBlockVisibility(unsigned int index, bool visible);
  bool GetBlockVisibility(unsigned int index);
  void RemoveBlockVisibility(unsigned int index);
  void RemoveBlockVisibilities();
  //@}

  //@{
  /**
   * The colour of a block, by its flat index: red, green, blue, in [0, 1]. Another value is an
   * error and changes nothing.
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
   * The opacity of a block, by its flat index, in [0, 1]. Another value is an error and changes
   * nothing.
   */
  void SetBlockOpacity(unsigned int index, double opacity);
  double GetBlockOpacity(unsigned int index);
  void RemoveBlockOpacity(unsigned int index);
  void RemoveBlockOpacities();
  //@}

  /**
   * Includes the time of the attributes.
   */
  vtkMTimeType GetMTime() override;

  /**
   * As VTK's own setters do: what VTK keeps on the graphics card is made anew.
   */
  void Modified() override;

  using vtkOpenGLPolyDataMapper::MapScalars;
  vtkUnsignedCharArray* MapScalars(vtkDataSet* input, double alpha, int& cellFlag) override;

protected:
  vtkBlockAttributesPolyDataMapper();
  ~vtkBlockAttributesPolyDataMapper() override;

  //@{
  /**
   * VTK's mapper compares GetMTime() with when it made buffers, textures and shaders. What they do
   * not depend on must not have them made anew, so as long as VTK asks it is told GetBuildMTime():
   * when Modified() was called, or the lookup table or clipping planes changed. Setters whose value
   * is read in every frame call SettingModified() in place of Modified(), and SetLive() does where
   * it changes the value.
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
  vtkTimeStamp BuildTime; // of Modified()
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
   * Have a mapper for each block of a composite input.
   */
  virtual void UpdateBlocks() = 0;

  //@{
  /**
   * The display attributes of the one data set that this mapper draws: its own, or those that the
   * mapper sets whose block it is.
   */
  const relevo::BlockAttributes& GetBlockAttributes();
  void SetBlockAttributes(const relevo::BlockAttributes& attributes);
  //@}

  /**
   * What VTK's text lacks of the shaders that are being written; see relevo::ShaderText.
   */
  std::set<std::string> MissingAnchors;

  /// The input, whoever asks: pickers are told another.
  vtkDataObject* GetTrueInput();

private:
  vtkBlockAttributesPolyDataMapper(const vtkBlockAttributesPolyDataMapper&) = delete;
  void operator=(const vtkBlockAttributesPolyDataMapper&) = delete;

  vtkDataObject* FindBlock(unsigned int index);
  /// An error where there is no such block; else makes the attributes.
  vtkDataObject* FindBlockToSet(unsigned int index);

  vtkSmartPointer<vtkCompositeDataDisplayAttributes> CompositeAttributes;
  std::unique_ptr<relevo::BlockAttributes> DisplayAttributes;
  double ColorResult[3] = { 1.0, 1.0, 1.0 };

  class Question;
  int NumberOfQuestions = 0; // of VTK's that are being answered
};

#endif
