// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Relief
 * @brief   validated access to a relief: an image with colours and depths seen from a camera
 *
 * A relief is a vtkImageData of n x m x 1 points with the point arrays "Color" (unsigned char, 3 or
 * 4 components), "Depth" (float, NaN without surface) and optionally "Normals" (float, 3
 * components, world coordinates), and the field arrays "ReliefProjection" (0 parallel, 1
 * perspective) and "ReliefMatrix" (16 doubles, row-major).
 *
 * All computations use texel space (c, r, w): column, row, and a height w, which is the depth d in
 * parallel projection and 1 / d in perspective. In this space, the surface between four texels is
 * bilinear for both projections, and the matrix TexelToWorld transforms it to the world:
 * ReliefMatrix * (c, r, d, 1) and ReliefMatrix * (c d, r d, d, 1) are multiples of TexelToWorld *
 * (c, r, w, 1). Straight lines remain straight. Private to the modules.
 */
#ifndef Relief_h
#define Relief_h

#include "Mathematics/RefinementMathematics.h"
#include "RelevoFiltersReliefModule.h" // for export macro
#include "vtkImageData.h"              // for the image
#include "vtkSmartPointer.h"

#include <string>

namespace relevo
{
enum class ReliefProjection
{
  Parallel = 0,
  Perspective = 1
};

class RELEVOFILTERSRELIEF_EXPORT Relief
{
public:
  static const char* GetColorName() { return "Color"; }
  static const char* GetDepthName() { return "Depth"; }
  static const char* GetNormalsName() { return "Normals"; }
  static const char* GetProjectionName() { return "ReliefProjection"; }
  static const char* GetMatrixName() { return "ReliefMatrix"; }
  /// The field array that distinguishes outputs of vtkReliefWarper from reliefs.
  static const char* GetWarpName() { return "ReliefWarp"; }

  /// Adds the field arrays of a relief to an image.
  static void Describe(vtkImageData* image, ReliefProjection projection, const dmat4& matrix);

  /// Validates an image and refers to its arrays. Returns an error, or "".
  std::string Read(vtkImageData* image);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  vtkIdType GetNumberOfTexels() const { return static_cast<vtkIdType>(this->Width) * this->Height; }
  vtkIdType GetNumberOfValidTexels() const { return this->NumberOfValidTexels; }
  ReliefProjection GetProjection() const { return this->Projection; }
  bool IsPerspective() const { return this->Projection == ReliefProjection::Perspective; }
  vtkImageData* GetImage() const { return this->Image; }

  /// Returns the colours in rows, with GetNumberOfColorComponents() bytes per texel.
  const unsigned char* GetColors() const { return this->Colors; }
  int GetNumberOfColorComponents() const { return this->NumberOfColorComponents; }
  const float* GetDepths() const { return this->Depths; }
  /// Returns nullptr without normals.
  const float* GetNormals() const { return this->Normals; }

  /// Returns the smallest and largest valid depth.
  const dvec2& GetDepthRange() const { return this->DepthRange; }
  /// Returns the smallest and largest valid height.
  dvec2 GetHeightRange() const;
  /// Returns the height of the relief's plane: depth 0, in perspective the nearest valid texel.
  double GetPlane() const;

  /// Homogeneous matrices between texel space and world.
  const dmat4& GetTexelToWorld() const { return this->TexelToWorld; }
  const dmat4& GetWorldToTexel() const { return this->WorldToTexel; }

  double ToHeight(double depth) const { return this->IsPerspective() ? 1.0 / depth : depth; }
  double ToDepth(double height) const { return this->IsPerspective() ? 1.0 / height : height; }
  /// Returns NaN without surface.
  double GetTexelHeight(int column, int row) const;
  dvec3 GetWorldPoint(double column, double row, double height) const;

private:
  std::string ReadArrays();
  std::string ReadDescription();
  std::string ReadDepths();

  vtkSmartPointer<vtkImageData> Image;
  int Width = 0;
  int Height = 0;
  int NumberOfColorComponents = 0;
  vtkIdType NumberOfValidTexels = 0;
  ReliefProjection Projection = ReliefProjection::Parallel;
  const unsigned char* Colors = nullptr;
  const float* Depths = nullptr;
  const float* Normals = nullptr;
  dvec2 DepthRange = dvec2(0.0);
  dmat4 TexelToWorld = dmat4(1.0);
  dmat4 WorldToTexel = dmat4(1.0);
};
}

#endif
