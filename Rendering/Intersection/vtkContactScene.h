// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkContactScene
 * @brief   finds which moving actors may touch, and where they do
 *
 * Call Update() when actors may have moved, such as before each frame. It processes actors at the
 * position of their matrices, visible or not, in two steps:
 *
 * Candidates are pairs of actors whose bounding boxes overlap in world coordinates. The boxes are
 * those of their mappers' bounds. The intersection of two boxes is set in the
 * vtkProximityDepthTagMetric of the actors' recipes, so that faces inside it get the highest level.
 * That metric is the one of a vtkAdaptiveRefinementMapper's recipe, or a part of its
 * vtkCompositeDepthTagMetric. A recipe without a metric gets one, with Distance. Recipes with other
 * metrics do not change. Actors with other mappers do not change either, but other actors can meet
 * them. Actors that share a recipe share its boxes. The scene replaces the metrics' boxes, and
 * removes them when an actor leaves the scene.
 *
 * Contacts, with ExactContacts, are the curves where the surfaces of candidates intersect. A
 * vtkSurfaceIntersectionFilter per pair computes them exactly. The filter is cached, so that its
 * trees are reused while actors move. Surfaces are the polygons and strips of the mapper's
 * vtkPolyData or, with RefinedContacts, the surface that the mapper's recipe makes of them. Actors
 * whose input has no surface, such as lines or blocks, only have boxes.
 *
 * Only pairs with an actor that has moved or whose input has changed are intersected again.
 *
 * Actors with bounds or a matrix that are not finite meet nothing. If surfaces cannot be
 * intersected, for example because of a singular matrix, one ErrorEvent names the two actors and
 * the reason, and they have no contact. A warning reports which cells of an input are ignored.
 *
 * @sa vtkSurfaceIntersectionFilter vtkProximityDepthTagMetric vtkAdaptiveRefinementMapper
 */
#ifndef vtkContactScene_h
#define vtkContactScene_h

#include "RelevoRenderingIntersectionModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for Internals
#include <string> // for Report

class vtkActor;
class vtkMultiBlockDataSet;

class RELEVORENDERINGINTERSECTION_EXPORT vtkContactScene : public vtkObject
{
public:
  static vtkContactScene* New();
  vtkTypeMacro(vtkContactScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Add, remove or return actors, in the order in which they were added, counted from 0. Adding
   * nullptr or an actor twice is an error and adds nothing. Removing an actor that is not in the
   * scene does nothing.
   */
  void AddActor(vtkActor* actor);
  void RemoveActor(vtkActor* actor);
  void RemoveAllActors();
  int GetNumberOfActors();
  vtkActor* GetActor(int index);
  //@}

  //@{
  /**
   * Set Distance of the metrics that the scene creates, in world units, at least 0, default 0; see
   * vtkProximityDepthTagMetric::SetDistance(). A value out of range is an error and changes
   * nothing.
   */
  void SetDistance(double distance);
  vtkGetMacro(Distance, double);
  //@}

  //@{
  /**
   * Set whether Update() computes where candidates intersect. On by default. Off, there are no
   * contacts.
   */
  vtkSetMacro(ExactContacts, bool);
  vtkGetMacro(ExactContacts, bool);
  vtkBooleanMacro(ExactContacts, bool);
  //@}

  //@{
  /**
   * Set whether contacts are computed on the curved, displaced surfaces of the recipes, refined to
   * Tolerance where they may intersect; see vtkSurfaceIntersectionFilter::SetRefinement(). Off by
   * default.
   */
  vtkSetMacro(RefinedContacts, bool);
  vtkGetMacro(RefinedContacts, bool);
  vtkBooleanMacro(RefinedContacts, bool);
  //@}

  //@{
  /**
   * Set the tolerance of refined contacts in world units, at least 0. The default, 0, refines as
   * far as the recipes allow; see vtkSurfaceIntersectionFilter::SetTolerance(). A value out of
   * range is an error and changes nothing.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  //@}

  /**
   * Find candidates and contacts for the current state of the actors.
   */
  void Update();

  /**
   * Return the contacts of the last Update(): one block per pair of touching actors, ordered by
   * their indices. A block is output 0 of vtkSurfaceIntersectionFilter in world coordinates, with
   * the field array "Actors" (vtkIntArray, the indices of both actors, the lower first). The
   * block's name contains the indices, too. The returned object is always the same; it is modified
   * when a contact changes.
   */
  vtkMultiBlockDataSet* GetContacts();

  /**
   * Return the number of pairs of actors whose boxes overlapped in the last Update().
   */
  vtkGetMacro(NumberOfCandidates, int);

  /**
   * Return the number of pairs of actors that the last Update() intersected.
   */
  vtkGetMacro(NumberOfIntersections, int);

protected:
  vtkContactScene();
  ~vtkContactScene() override;

private:
  vtkContactScene(const vtkContactScene&) = delete;
  void operator=(const vtkContactScene&) = delete;

  struct Internals;

  void FindContacts();
  void Report(const std::string& pair, const std::string& errors, const std::string& warnings);

  double Distance = 0.0;
  bool ExactContacts = true;
  bool RefinedContacts = false;
  double Tolerance = 0.0;
  int NumberOfCandidates = 0;
  int NumberOfIntersections = 0;
  std::unique_ptr<Internals> Scene;
};

#endif
