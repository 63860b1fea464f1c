// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkArrayQuantityFilter
 * @brief   compute a number from each vector or tensor, such as the von Mises stress
 *
 * The output is the input with one more array for each point or cell array that the quantity names.
 * The array has the name of the quantity, one component (double) and the information of its source,
 * for example a unit. These are the quantities of an array A. Their words are in upper or lower
 * case:
 *
 * - for 2 or 3 components: "x of A", "y of A", "z of A"
 * - for 6 or 9 components, tensors: "xx of A", and likewise yy, zz, xy, yz, xz; with 9 also yx, zy,
 *   zx
 * - for tensors: "von Mises of A", "Tresca of A", the difference of the largest and the smallest
 *   principal value, and "principal 1 of A" (the largest), "principal 2 of A", "principal 3 of A"
 * - for any array: "magnitude of A", "component N of A", where N counts from 0, and "mean of A",
 * the arithmetic mean of the components, for example of a cell array with one component for each
 *   integration point
 *
 * Six components are xx, yy, zz, xy, yz, xz, as in VTK. Nine are rows of a matrix; all quantities
 * except components use its symmetric part. "von Mises", "Tresca" and principal values alone take
 * the only tensor.
 *
 * The von Mises stress is sqrt(((xx - yy)^2 + (yy - zz)^2 + (zz - xx)^2) / 2 + 3 (xy^2 + yz^2 +
 * xz^2)). Numbers that are not finite give NaN. In curved cells, quantities are those at the nodes.
 *
 * Other names, and names that an array has, change nothing. It is an error if no block has a source
 * of the quantity; the output is then the input.
 *
 * @sa vtkArrayCalculator
 */
#ifndef vtkArrayQuantityFilter_h
#define vtkArrayQuantityFilter_h

#include "RelevoFiltersVolumeModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <string> // for names

class vtkStringArray;

class RELEVOFILTERSVOLUME_EXPORT vtkArrayQuantityFilter : public vtkPassInputTypeAlgorithm
{
public:
  static vtkArrayQuantityFilter* New();
  vtkTypeMacro(vtkArrayQuantityFilter, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set the quantity, for example "von Mises of Stress"; none by default.
   */
  vtkSetStdStringFromCharMacro(Quantity);
  vtkGetCharFromStdStringMacro(Quantity);
  //@}

  /**
   * Get the name of the new array after an update. It is the quantity, completed by the name of the
   * source. If nothing has been computed, it is the quantity as it was set.
   */
  vtkGetCharFromStdStringMacro(ResultName);

  /**
   * Fill a list with the quantities of an array with this name and number of components, in the
   * order of a menu. There are none for a single component. "mean of A" and "component N of A" are
   * listed only if the components have no other names.
   */
  static void ListQuantities(
    const char* arrayName, int numberOfComponents, vtkStringArray* quantities);

protected:
  vtkArrayQuantityFilter();
  ~vtkArrayQuantityFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkArrayQuantityFilter(const vtkArrayQuantityFilter&) = delete;
  void operator=(const vtkArrayQuantityFilter&) = delete;

  std::string Quantity;
  std::string ResultName;
};

#endif
