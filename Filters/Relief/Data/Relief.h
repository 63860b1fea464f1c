// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   Relief
 * @brief   a checked view of an image that is a relief: colours and depths seen by one camera
 *
 * A relief is a vtkImageData of n x m x 1 points with the point arrays "Color" (unsigned char, 3 or
 * 4 components), "Depth" (float, NaN where nothing was seen) and, if wanted, "Normals" (float, 3
 * components, world), and the field arrays "ReliefProjection" (0 parallel, 1 perspective) and
 * "ReliefMatrix" (16 doubles, by rows).
 *
 * Everything else is computed in texel space (c, r, w): column, row, and a height w that is the
 * depth d in parallel projection, 1 / d in perspective. There the surface between four texels is
 * bilinear in both, and one matrix, TexelToWorld, takes it to the world: ReliefMatrix times (c, r,
 * d, 1) and ReliefMatrix times (c d, r d, d, 1) are, but for a factor, this matrix times (c, r, w,
 * 1). Straight lines stay straight. Private to the modules' own sources.
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
  /// The field array that tells what vtkReliefWarper makes of a relief from one.
  static const char* GetWarpName() { return "ReliefWarp"; }

  /// Gives an image the field arrays of a relief.
  static void Describe(vtkImageData* image, ReliefProjection projection, const dmat4& matrix);

  /// Checks an image and refers to its arrays; what is wrong with it, or "".
  std::string Read(vtkImageData* image);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  vtkIdType GetNumberOfTexels() const { return static_cast<vtkIdType>(this->Width) * this->Height; }
  vtkIdType GetNumberOfValidTexels() const { return this->NumberOfValidTexels; }
  ReliefProjection GetProjection() const { return this->Projection; }
  bool IsPerspective() const { return this->Projection == ReliefProjection::Perspective; }
  vtkImageData* GetImage() const { return this->Image; }

  /// Row after row, GetNumberOfColorComponents() to a texel.
  const unsigned char* GetColors() const { return this->Colors; }
  int GetNumberOfColorComponents() const { return this->NumberOfColorComponents; }
  const float* GetDepths() const { return this->Depths; }
  /// nullptr where there are none.
  const float* GetNormals() const { return this->Normals; }

  /// Smallest and largest of the valid depths.
  const dvec2& GetDepthRange() const { return this->DepthRange; }
  /// Smallest and largest of the valid heights.
  dvec2 GetHeightRange() const;
  /// The height of the relief's plane: of depth 0, in perspective of the nearest valid texel.
  double GetPlane() const;

  /// From texel space to the world, and back; homogeneous.
  const dmat4& GetTexelToWorld() const { return this->TexelToWorld; }
  const dmat4& GetWorldToTexel() const { return this->WorldToTexel; }

  double ToHeight(double depth) const { return this->IsPerspective() ? 1.0 / depth : depth; }
  double ToDepth(double height) const { return this->IsPerspective() ? 1.0 / height : height; }
  /// NaN where nothing was seen.
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
