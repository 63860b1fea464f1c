// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Text/ViewerText.h"

#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextActor> MakeText()
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->VisibilityOff();
  vtkTextProperty* property = text->GetTextProperty();
  property->SetColor(0.1, 0.1, 0.1);
  property->SetBackgroundColor(1.0, 1.0, 1.0);
  property->SetBackgroundOpacity(0.7);
  property->SetFontSize(14);
  return text;
}

//------------------------------------------------------------------------------
std::string FormatNumber(double number, double resolution)
{
  const int most = 12;
  const double digits = resolution > 0.0 ? std::ceil(-std::log10(resolution)) : most;
  const int decimals = static_cast<int>(std::min<double>(std::max(digits, 0.0), most));
  // Avoids -0.
  const double unit = std::pow(10.0, -decimals);
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals)
         << (std::abs(number) < 0.5 * unit ? 0.0 : number);
  return stream.str();
}

//------------------------------------------------------------------------------
std::string JoinNumbers(const std::vector<double>& numbers)
{
  std::ostringstream text;
  text << std::setprecision(5);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    text << (i > 0 ? "," : "") << numbers[i];
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string JoinWords(const std::vector<std::string>& words)
{
  std::string joined;
  for (size_t i = 0; i < words.size(); ++i)
  {
    joined += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return joined;
}
