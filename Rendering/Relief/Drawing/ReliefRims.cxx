// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/ReliefRims.h"

#include "Data/Relief.h"
#include "Data/ReliefSides.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace relevo
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
// The largest curvature of a face, as a deviation in texels per texel; rounded edges are not sharp.
constexpr double MaximumBent = 0.15;
// Faces with a larger cosine of the angle between them are the same, or the two sides of a thin
// plate.
constexpr double Parallel = 0.95;
// A face with a smaller cosine ends the search for another one.
constexpr double Across = 0.5;
// The number of other reliefs to search, distributed evenly if there are more.
constexpr size_t MaximumOthers = 32;
// The distance, in texels, from a face to where the fourth component is 0 or 255.
constexpr double Reach = 2.0;

// Return the surface normal in world coordinates towards the viewer; 0 if there is none.
dvec3 FindNormal(const Relief& relief, const dvec3& point, const dvec3& right, const dvec3& up,
  double column, double row, double height)
{
  const double nearer = relief.IsPerspective() ? 1.001 * height : height - 1.0;
  const dvec3 normal = cross(right - point, up - point);
  const double size = length(normal);
  const double side = dot(normal, relief.GetWorldPoint(column, row, nearer) - point);
  return size > 0.0 ? normal * ((side < 0.0 ? -1.0 : 1.0) / size) : dvec3(0.0);
}

// A point on the extension of a face.
struct RimPoint
{
  dvec3 Point;
  dvec3 Normal;
  double Width; // width of a texel
};

// A face at an angle to an extended one.
struct OtherFace
{
  double Cosine = Parallel; // of the angle between the two faces
  dvec3 Point{ 0.0 };
  dvec3 Normal{ 0.0 };

  bool IsThere() const { return this->Cosine < Parallel; }
};

// Find the quad of a relief near a point that is most nearly perpendicular to the face.
void FindOtherFace(const RimSource& source, const RimPoint& rim, OtherFace& found)
{
  const Relief& relief = *source.Surface;
  const dvec4 place = relief.GetWorldToTexel() * dvec4(rim.Point, 1.0);
  const dvec2 texel(place.x / place.w, place.y / place.w);
  const ivec2 last(relief.GetWidth() - 2, relief.GetHeight() - 2);
  if (!(texel.x > -2.0 && texel.y > -2.0 && texel.x < last.x + 3.0 && texel.y < last.y + 3.0))
  {
    return;
  }
  const ivec2 middle(std::lround(texel.x), std::lround(texel.y));
  const ivec2 least = max(middle - 2, ivec2(0));
  const ivec2 most = min(middle + 1, last);
  for (int row = least.y; row <= most.y; ++row)
  {
    for (int column = least.x; column <= most.x; ++column)
    {
      if (!(source.Sides[static_cast<size_t>(row) * relief.GetWidth() + column] & Quad))
      {
        continue;
      }
      const auto point = [&](int right, int up)
      {
        return relief.GetWorldPoint(
          column + right, row + up, relief.GetTexelHeight(column + right, row + up));
      };
      const dvec3 corner = point(0, 0);
      const dvec3 right = point(1, 0);
      const dvec3 up = point(0, 1);
      const double width = std::min(distance(corner, right), distance(corner, up));
      if (distance(corner, rim.Point) > 3.0 * (width + rim.Width))
      {
        continue;
      }
      const dvec3 normal =
        FindNormal(relief, corner, right, up, column, row, relief.GetTexelHeight(column, row));
      const double cosine = dot(normal, rim.Normal);
      if (cosine < found.Cosine && cosine > -Parallel && length(normal) > 0.5)
      {
        found.Cosine = cosine;
        found.Point = corner;
        found.Normal = normal;
      }
    }
  }
}

class Rims
{
public:
  Rims(const std::vector<RimSource>& sources, size_t index)
    : Sources(sources)
    , Index(index)
    , Source(*sources[index].Surface)
    , Sides(sources[index].Sides)
    , Nearer(this->Source.IsPerspective() ? 1.0 : -1.0)
    , Width(this->Source.GetWidth() + 2 * RimMargin)
    , Height(this->Source.GetHeight() + 2 * RimMargin)
    , Texels(static_cast<size_t>(this->Width) * this->Height)
  {
  }

  bool Make()
  {
    for (int row = 0; row < this->Source.GetHeight(); ++row)
    {
      for (int column = 0; column < this->Source.GetWidth(); ++column)
      {
        const int quads = this->CountQuads(column, row);
        if (quads > 0 && quads < 4)
        {
          this->Continue(column, row);
        }
      }
    }
    return this->FindEnds();
  }

  vtkSmartPointer<vtkImageData> MakeImage() const
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(this->Width, this->Height, 1);
    const auto number = static_cast<vtkIdType>(this->Texels.size());
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(Relief::GetColorName());
    colors->SetNumberOfComponents(4);
    colors->SetNumberOfTuples(number);
    colors->Fill(0.0);
    vtkNew<vtkFloatArray> depths;
    depths->SetName(Relief::GetDepthName());
    depths->SetNumberOfTuples(number);
    depths->Fill(NaN);
    vtkNew<vtkFloatArray> normals;
    normals->SetName(Relief::GetNormalsName());
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(this->Source.GetNormals() ? number : 0);
    normals->Fill(0.0);
    const int components = this->Source.GetNumberOfColorComponents();
    for (vtkIdType i = 0; i < number; ++i)
    {
      const Texel& texel = this->Texels[i];
      if (!texel.IsNearEdge)
      {
        continue;
      }
      depths->SetValue(i, static_cast<float>(this->Source.ToDepth(texel.Height)));
      unsigned char* color = colors->GetPointer(4 * i);
      std::copy_n(this->Source.GetColors() + components * texel.Origin, 3, color);
      color[3] = texel.Inside;
      if (this->Source.GetNormals())
      {
        std::copy_n(this->Source.GetNormals() + 3 * texel.Origin, 3, normals->GetPointer(3 * i));
      }
    }
    image->GetPointData()->AddArray(colors);
    image->GetPointData()->AddArray(depths);
    if (this->Source.GetNormals())
    {
      image->GetPointData()->AddArray(normals);
    }
    Relief::Describe(image, this->Source.GetProjection(), this->GetMatrix());
    return image;
  }

private:
  struct Texel
  {
    double Height = NaN;
    vtkIdType Origin = -1; // the source's texel whose face is extended
    unsigned char Inside = 0;
    bool IsNearEdge = false;
  };

  bool Contains(int column, int row) const
  {
    return column >= 0 && row >= 0 && column < this->Source.GetWidth() &&
      row < this->Source.GetHeight();
  }
  bool HasSide(int column, int row, ReliefSide side) const
  {
    return this->Contains(column, row) &&
      (this->Sides[static_cast<size_t>(row) * this->Source.GetWidth() + column] & side) != 0;
  }
  double GetHeight(int column, int row) const
  {
    return this->Contains(column, row) ? this->Source.GetTexelHeight(column, row) : NaN;
  }
  bool IsFarther(double height, double other) const
  {
    return height * this->Nearer < other * this->Nearer;
  }

  // Count the valid quads of the four around a texel.
  int CountQuads(int column, int row) const
  {
    return this->HasSide(column, row, Quad) + this->HasSide(column - 1, row, Quad) +
      this->HasSide(column, row - 1, Quad) + this->HasSide(column - 1, row - 1, Quad);
  }

  // Return the change of the height per step to the right or up, from the connected texels.
  double FindSlope(int column, int row, int right, int up, ReliefSide side) const
  {
    const double height = this->GetHeight(column, row);
    double sum = 0.0;
    int number = 0;
    if (this->HasSide(column, row, side))
    {
      sum += this->GetHeight(column + right, row + up) - height;
      ++number;
    }
    if (this->HasSide(column - right, row - up, side))
    {
      sum += height - this->GetHeight(column - right, row - up);
      ++number;
    }
    return number > 0 ? sum / number : 0.0;
  }
  dvec2 FindSlopes(int column, int row) const
  {
    return dvec2(
      this->FindSlope(column, row, 1, 0, RightSide), this->FindSlope(column, row, 0, 1, UpperSide));
  }

  // Extend to all neighbours that are not connected.
  void Continue(int column, int row)
  {
    const double height = this->GetHeight(column, row);
    const dvec2 slopes = this->FindSlopes(column, row);
    const vtkIdType origin = static_cast<vtkIdType>(row) * this->Source.GetWidth() + column;
    for (int i = 0; i < 9; ++i)
    {
      const int right = i % 3 - 1;
      const int up = i / 3 - 1;
      const double next = height + right * slopes.x + up * slopes.y;
      if ((right != 0 || up != 0) && this->MayContinue(column, row, right, up, next))
      {
        this->Set(column, row, height, origin);
        this->Set(column + right, row + up, next, origin);
      }
    }
  }

  bool MayContinue(int column, int row, int right, int up, double next) const
  {
    if (this->Source.IsPerspective() && !(next > 0.0))
    {
      return false;
    }
    const double height = this->GetHeight(column, row);
    const auto point = [&](int steps, double w)
    { return this->Source.GetWorldPoint(column + steps * right, row + steps * up, w); };
    const double width = distance(point(0, height), point(1, height));
    if (!(distance(point(0, height), point(1, next)) <= RimStretch * width))
    {
      return false;
    }
    // Extrapolate from the two texels before, unless they are on another face.
    const double before = this->GetHeight(column - right, row - up);
    const double first = this->GetHeight(column - 2 * right, row - 2 * up);
    const double bent = distance(point(0, height), point(0, 2.0 * before - first));
    if (bent > MaximumBent * width && bent <= RimStretch * width)
    {
      return false;
    }
    const double own = this->GetHeight(column + right, row + up);
    return std::isnan(own) ||
      (this->IsFarther(own, next) && distance(point(1, own), point(1, next)) > RimStretch * width);
  }

  // If two extensions meet, use the farther one.
  void Set(int column, int row, double height, vtkIdType origin)
  {
    Texel& texel =
      this->Texels[static_cast<size_t>(row + RimMargin) * this->Width + column + RimMargin];
    if (std::isnan(texel.Height) || this->IsFarther(height, texel.Height))
    {
      texel.Height = height;
      texel.Origin = origin;
    }
  }

  // Return whether an extension reaches an edge anywhere.
  bool FindEnds()
  {
    vtkSMPTools::For(0, this->Height,
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin * this->Width; i < end * this->Width; ++i)
        {
          if (this->Texels[i].Origin >= 0)
          {
            this->FindEnd(static_cast<int>(i % this->Width) - RimMargin,
              static_cast<int>(i / this->Width) - RimMargin, this->Texels[i]);
          }
        }
      });
    return std::any_of(this->Texels.begin(), this->Texels.end(),
      [](const Texel& texel) { return texel.IsNearEdge; });
  }

  void FindEnd(int column, int row, Texel& texel) const
  {
    RimPoint rim;
    rim.Point = this->Source.GetWorldPoint(column, row, texel.Height);
    rim.Width = distance(rim.Point, this->Source.GetWorldPoint(column + 1, row, texel.Height));
    const dvec2 slopes = this->FindSlopes(static_cast<int>(texel.Origin % this->Source.GetWidth()),
      static_cast<int>(texel.Origin / this->Source.GetWidth()));
    rim.Normal = FindNormal(this->Source, rim.Point,
      this->Source.GetWorldPoint(column + 1, row, texel.Height + slopes.x),
      this->Source.GetWorldPoint(column, row + 1, texel.Height + slopes.y), column, row,
      texel.Height);
    OtherFace face;
    const size_t step = (this->Sources.size() + MaximumOthers - 1) / MaximumOthers;
    for (size_t i = 1; i < this->Sources.size() && face.Cosine > Across; i += step)
    {
      FindOtherFace(this->Sources[(this->Index + i) % this->Sources.size()], rim, face);
    }
    if (face.IsThere())
    {
      const double outside = dot(face.Normal, rim.Point - face.Point) / rim.Width;
      texel.IsNearEdge = true;
      texel.Inside = static_cast<unsigned char>(
        std::lround(std::clamp(127.5 * (1.0 - outside / Reach), 0.0, 255.0)));
    }
  }

  // Return the source's matrix, with columns and rows counted from the margin.
  dmat4 GetMatrix() const
  {
    dmat4 matrix = this->Source.GetTexelToWorld();
    matrix[3] -= static_cast<double>(RimMargin) * (matrix[0] + matrix[1]);
    if (this->Source.IsPerspective())
    {
      std::swap(matrix[2], matrix[3]); // heights are inverse depths
    }
    return matrix;
  }

  const std::vector<RimSource>& Sources;
  const size_t Index;
  const Relief& Source;
  const std::vector<unsigned char>& Sides;
  const double Nearer; // the sign of heights that grow towards the viewer
  const int Width;
  const int Height;
  std::vector<Texel> Texels;
};
}

vtkSmartPointer<vtkImageData> MakeReliefRims(const std::vector<RimSource>& sources, size_t index)
{
  Rims rims(sources, index);
  return rims.Make() ? rims.MakeImage() : nullptr;
}
}
