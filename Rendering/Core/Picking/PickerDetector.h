// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   PickerDetector
 * @brief   tells whether it is a picker that asks a mapper for its input
 *
 * VTK's pickers intersect a mapper's input by themselves, and say nothing about it that a mapper
 * could override. What they ask beforehand gives them away: GetBounds(double[6]), which VTK calls
 * nowhere else, and then, with nothing in between, the input; where it is composite, once more.
 * vtkPicker asks for the center first, and with it for GetBounds(). A picker that misses the bounds
 * leaves the question open: pickers ask a vtkMapper, so the mapper's own class answers all that its
 * users ask of it by the input itself.
 */
#ifndef PickerDetector_h
#define PickerDetector_h

namespace relevo
{
class PickerDetector
{
public:
  /// GetBounds(double[6]); anything that pickers do not ask.
  void AskBounds() { this->Last = BOUNDS; }
  void AskOther() { this->Last = OTHER; }

  enum Askers
  {
    NO_PICKER,
    PICKER_OF_BOUNDS, // vtkPicker
    PICKER_OF_PARTS   // vtkCellPicker, vtkPointPicker
  };
  /// The input: who asks for it.
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

/// GetBounds(), for as long as it takes: what the mapper then asks for itself is no picker's.
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
