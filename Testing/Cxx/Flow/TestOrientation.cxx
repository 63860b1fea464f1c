// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
// Proves that the tests measure directions correctly, using images of lines with known directions.
#include "RelevoCheck.h"
#include "RelevoOrientation.h"

#include <functional>
#include <iostream>
#include <random>

namespace
{
constexpr int Size = 256;

// Coordinate in pixels, relative to the image's centre.
double Place(int pixel)
{
  return pixel - 0.5 * (Size - 1);
}

RelevoGrey MakeImage(const std::function<double(double x, double y)>& value)
{
  RelevoGrey image(Size, Size);
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      image.At(column, row) = value(Place(column), Place(row));
    }
  }
  return image;
}

// Lines of constant t with random grey values, about two pixels wide.
class Profile
{
public:
  Profile()
  {
    std::mt19937 random(7);
    for (double& frequency : this->Frequencies)
    {
      frequency = 0.1 + 1.4 * random() / 4294967296.0;
    }
    for (double& phase : this->Phases)
    {
      phase = 6.283 * random() / 4294967296.0;
    }
  }
  double operator()(double t) const
  {
    double sum = 0.0;
    for (int i = 0; i < 20; ++i)
    {
      sum += std::sin(this->Frequencies[i] * t + this->Phases[i]);
    }
    return sum;
  }

private:
  double Frequencies[20];
  double Phases[20];
};

RelevoDeviations Measure(const RelevoGrey& image,
  const std::function<void(double x, double y, double* vector)>& field, double innerRadius = 0.0)
{
  return MeasureDeviations(RelevoOrientation(image),
    [&](int column, int row, double* vector)
    {
      const double x = Place(column);
      const double y = Place(row);
      field(x, y, vector);
      return std::hypot(x, y) > innerRadius && std::max(std::abs(x), std::abs(y)) < 110.0;
    });
}
}

int TestOrientation(int, char*[])
{
  RelevoCheck check;
  const Profile profile;
  for (int degrees = 0; degrees < 180; degrees += 7)
  {
    const double angle = vtkMath::RadiansFromDegrees(static_cast<double>(degrees));
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const RelevoGrey stripes =
      MakeImage([&](double x, double y) { return profile(c * y - s * x); });
    for (double tilt : { 0.0, 10.0, -33.0, 90.0 })
    {
      CHECK_CASE(tilt);
      const double turned = angle + vtkMath::RadiansFromDegrees(tilt);
      const RelevoDeviations deviations = Measure(stripes,
        [=](double, double, double* vector)
        {
          vector[0] = 3.0 * std::cos(turned);
          vector[1] = 3.0 * std::sin(turned);
        });
      CHECK_NEAR(deviations.Median, std::abs(tilt), 0.1);
      CHECK_NEAR(deviations.Percentile95, std::abs(tilt), 0.5);
    }
    CHECK_GREATER(RelevoOrientation(stripes).GetCoherence(Size / 2, Size / 2), 0.99);
  }

  const RelevoGrey rings = MakeImage([&](double x, double y) { return profile(std::hypot(x, y)); });
  const RelevoDeviations around = Measure(
    rings,
    [](double x, double y, double* vector)
    {
      vector[0] = -y;
      vector[1] = x;
    },
    15.0);
  std::cout << "rings: " << around << "\n";
  CHECK_GREATER(around.Count, 40000);
  CHECK_LESS(around.Median, 0.1);
  CHECK_LESS(around.Percentile95, 0.5);

  // Noise without lines has no direction.
  std::mt19937 random(3);
  const RelevoGrey noise = MakeImage([&](double, double) { return static_cast<double>(random()); });
  const RelevoDeviations none = Measure(noise,
    [](double, double, double* vector)
    {
      vector[0] = 1.0;
      vector[1] = 0.0;
    });
  CHECK_NEAR(none.Median, 45.0, 6.0);
  const RelevoOrientation flat(MakeImage([](double, double) { return 0.0; }));
  CHECK_EQUAL(flat.GetCoherence(10, 10), 0.0);
  return check.GetResult();
}
