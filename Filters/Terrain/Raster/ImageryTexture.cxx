// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster/ImageryTexture.h"

#include "Raster/ImageryDrape.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <sstream>

namespace relevo
{
bool MakeImageryTexture(const ImagerySource& source, const Georeference& terrain,
  vtkImageData* texture, const ImageryProgress& progress, std::string& warning, std::string& error)
{
  Imagery imagery;
  if (!DrapeImagery(source, terrain, imagery, progress, error))
  {
    error = error.empty() ? error : "Cannot drape " + source.FileName + ": " + error + ".";
    return false;
  }
  warning.clear();
  if (imagery.FullSize[0] > imagery.Width || imagery.FullSize[1] > imagery.Height)
  {
    std::ostringstream text;
    text << source.FileName << " has about " << imagery.FullSize[0] << " x " << imagery.FullSize[1]
         << " pixels over the terrain, but the limit is " << source.MaximumSize
         << " per side: it is reduced to " << imagery.Width << " x " << imagery.Height << ".";
    warning = text.str();
  }
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetName("Imagery");
  pixels->SetNumberOfComponents(3);
  pixels->SetArray(imagery.Pixels.release(), static_cast<vtkIdType>(imagery.GetNumberOfValues()), 0,
    vtkUnsignedCharArray::VTK_DATA_ARRAY_DELETE);
  texture->SetDimensions(imagery.Width, imagery.Height, 1);
  texture->GetPointData()->SetScalars(pixels);
  texture->Modified();
  return true;
}
}
