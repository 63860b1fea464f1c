// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickerDetector
 * @brief   detects whether a picker requests a mapper's input
 *
 * VTK's pickers intersect a mapper's input themselves, without a method that a mapper could
 * override. They can be detected by the calls before: GetBounds(double[6]), which VTK does not call
 * elsewhere, immediately followed by a request for the input, twice if it is composite. vtkPicker
 * first calls GetCenter(), which calls GetBounds(). A picker that does not call GetBounds() is not
 * detected. Pickers call methods of vtkMapper; the methods of the mapper's own class, which its
 * users call, always return the input itself.
 */
#ifndef PickerDetector_h
#define PickerDetector_h

namespace relevo
{
class PickerDetector
{
public:
  /// Record a call of GetBounds(double[6]), or of another method, which pickers do not call.
  void AskBounds() { this->Last = BOUNDS; }
  void AskOther() { this->Last = OTHER; }

  enum Askers
  {
    NO_PICKER,
    PICKER_OF_BOUNDS, // vtkPicker
    PICKER_OF_PARTS   // vtkCellPicker, vtkPointPicker
  };
  /// Return who requests the input.
  Askers AskInput(bool isComposite)
  {
    const Question last = this->Last;
    this->Last = last == BOUNDS && isComposite ? DATASET : OTHER;
    return last == BOUNDS || last == DATASET ? PICKER_OF_PARTS
      : last == CENTER && isComposite        ? PICKER_OF_BOUNDS
                                             : NO_PICKER;
  }

private:
  friend class OwnBoundsQuestion;
  enum Question
  {
    OTHER,
    BOUNDS,
    CENTER,
    DATASET
  };
  Question Last = OTHER;
};

/// Guards the mapper's own call of GetBounds(), so that requests inside it do not count as a
/// picker's.
class OwnBoundsQuestion
{
public:
  explicit OwnBoundsQuestion(PickerDetector& questions)
    : Questions(questions)
    , Next(
        questions.Last == PickerDetector::BOUNDS ? PickerDetector::CENTER : PickerDetector::OTHER)
  {
    questions.Last = PickerDetector::OTHER;
  }
  ~OwnBoundsQuestion() { this->Questions.Last = this->Next; }
  OwnBoundsQuestion(const OwnBoundsQuestion&) = delete;
  void operator=(const OwnBoundsQuestion&) = delete;

private:
  PickerDetector& Questions;
  const PickerDetector::Question Next;
};
}

#endif
