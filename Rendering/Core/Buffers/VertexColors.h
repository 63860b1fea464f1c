// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   VertexColors
 * @brief   point scalars and their lookup table on the GPU
 *
 * VTK maps the scalars of coarse points to colours and interpolates the colours. On a refined
 * surface, scalars are interpolated first and then mapped at each refined point, as by a mapper of
 * the refined mesh. Coarse points keep VTK's colours. Private to the modules.
 */
#ifndef VertexColors_h
#define VertexColors_h

#include "Buffers/BufferTexture.h"     // for members
#include "Buffers/ColorTable.h"        // for members
#include "Changes/Dependencies.h"      // for members
#include "RelevoRenderingCoreModule.h" // for export macro
#include "vtkType.h"                   // for VTK_VOID

class vtkAbstractArray;
class vtkDataArray;
class vtkScalarsToColors;

namespace relevo
{
/// How points between the coarse ones get their colours of scalars.
enum ScalarKind
{
  BY_VTK,     // VTK's colours or texture coordinates are interpolated
  BY_VALUE,   // values are interpolated and looked up
  BY_TEXTURE, // values are interpolated and become VTK's texture coordinate in the table
  BY_NEAREST  // the nearest corner's colour is used
};

class RELEVORENDERINGCORE_EXPORT VertexColors
{
public:
  /**
   * Upload point scalars that are mapped by a lookup table (not direct colours). `component` is
   * that of vtkMapper; -1 uses that of the table. `byTexture` means that VTK colours by a texture.
   * For noDataMagnitude see NoDataTuples. `type` is the type of the values, if the scalars are
   * their coefficients. Values that have not changed are not uploaded again: they depend on the
   * range of the table only if it is very narrow compared to its distance from the smallest value.
   * Return false if they do not fit on the GPU.
   */
  bool Upload(vtkOpenGLRenderWindow* window, vtkAbstractArray* scalars, vtkScalarsToColors* table,
    int component, bool byTexture, double noDataMagnitude, int type = VTK_VOID);

  ScalarKind GetKind() const { return this->Kind; }
  /// Return whether a point has a single number, not a vector of which the length is used.
  bool IsNumber() const { return this->Texels == 0; }
  /// Return whether some of the values are no data.
  bool HasNoData() const { return this->Kind != BY_VTK && !this->NoData.IsEmpty(); }
  /// Return the number that has been subtracted from all values.
  double GetBias() const { return this->Bias; }
  /// Return how often values were uploaded.
  vtkIdType GetNumberOfUploads() const { return this->NumberOfUploads; }
  void Clear() { this->Kind = BY_VTK; }

  void Activate(vtkShaderProgram* program);
  void Deactivate();
  vtkTypeInt64 GetMemorySize() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// The components of the value that is mapped: a number, or a vector of which the length is used.
  struct Choice
  {
    int First = 0;
    int Count = 1; // 0: the mapping is not a function of one value
    bool IsLength = false;
  };
  static Choice ChooseComponents(int components, vtkScalarsToColors* table, int component);
  static Choice ChooseTextureComponents(int components, vtkScalarsToColors* table);

  void FindRange(vtkDataArray* scalars, const Choice& choice);
  void ChooseBias(vtkScalarsToColors* table, const Choice& choice);
  bool UploadValues(vtkOpenGLRenderWindow* window, vtkDataArray* scalars, const Choice& choice);
  bool UploadNoData(vtkOpenGLRenderWindow* window, vtkDataArray* scalars, double noDataMagnitude);
  void SetCoordinates(vtkScalarsToColors* table);

  BufferTexture Scalars;
  BufferTexture NoData;
  ColorTable Table;
  Dependencies RangeDependencies;
  Dependencies UploadDependencies;
  double Range[2] = { 0.0, 0.0 }; // of the values
  ScalarKind Kind = BY_VTK;
  int Texels = 0; // per point; 0 for a single number
  bool AreIntegers = false;
  double Bias = 0.0;
  float Coordinates[3] = { 0.0f, 0.0f, 0.0f }; // minimum, 1 / width, log
  vtkIdType NumberOfUploads = 0;
};
}

#endif
