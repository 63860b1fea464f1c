// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkContactScene
 * @brief   which of some moving actors may meet, and where they do
 *
 * Call Update() when actors may have moved, such as before each frame. It looks at actors wherever
 * their matrices put them, visible or not, in two steps:
 *
 * Candidates: pairs of actors whose world boxes, those of their mappers' bounds, meet. The boxes
 * that two have in common are kept in the vtkProximityDepthTagMetric of their recipes, so that
 * faces in them are refined most. It is the metric of the recipe of a vtkAdaptiveRefinementMapper,
 * or one that this metric, a vtkCompositeDepthTagMetric, is made of; a recipe without a metric gets
 * one, with Distance. Recipes with another metric stay as they are, and actors with another mapper
 * only are what others meet. Actors that share a recipe share its boxes. The metrics' own boxes are
 * replaced, and removed when an actor leaves the scene.
 *
 * Contacts, with ExactContacts: the curves where the surfaces of candidates meet, decided exactly
 * by a vtkSurfaceIntersectionFilter for each pair, which is kept, so that its trees survive motion.
 * Surfaces are the polygons and strips of the mapper's input, a vtkPolyData, as they are; or, with
 * RefinedContacts, what the mapper's recipe makes of them. Actors whose input has none, such as
 * lines or blocks, have boxes alone.
 *
 * Only pairs of actors that have moved, or whose input has changed, are intersected anew.
 *
 * Actors whose bounds or matrix are not finite meet nothing. Where surfaces cannot be intersected,
 * as those of a singular matrix, an ErrorEvent names the two and says why, once, and they have no
 * contact; so does a warning of what is left out of an input.
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
   * The actors, in the order in which they were added, counted from 0. None (nullptr), and one that
   * is there already, are errors and add nothing; one that is not there is none to remove.
   */
  void AddActor(vtkActor* actor);
  void RemoveActor(vtkActor* actor);
  void RemoveAllActors();
  int GetNumberOfActors();
  vtkActor* GetActor(int index);
  //@}

  //@{
  /**
   * Distance of the metrics that the scene makes, in world units, at least 0, default 0; see
   * vtkProximityDepthTagMetric::SetDistance(). Another value is an error and changes nothing.
   */
  void SetDistance(double distance);
  vtkGetMacro(Distance, double);
  //@}

  //@{
  /**
   * Whether Update() computes where candidates meet; default on. Without, there are no contacts.
   */
  vtkSetMacro(ExactContacts, bool);
  vtkGetMacro(ExactContacts, bool);
  vtkBooleanMacro(ExactContacts, bool);
  //@}

  //@{
  /**
   * Whether contacts are those of the curved, displaced surfaces that recipes make, refined to
   * Tolerance where they may meet, see vtkSurfaceIntersectionFilter::SetRefinement(); default off.
   */
  vtkSetMacro(RefinedContacts, bool);
  vtkGetMacro(RefinedContacts, bool);
  vtkBooleanMacro(RefinedContacts, bool);
  //@}

  //@{
  /**
   * In world units, at least 0, default 0: as fine as recipes allow; see
   * vtkSurfaceIntersectionFilter::SetTolerance(). Another value is an error and changes nothing.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  //@}

  /**
   * Look at the actors as they are.
   */
  void Update();

  /**
   * The contacts of the last Update(): a block for each pair of actors that touch, by their
   * numbers: output 0 of vtkSurfaceIntersectionFilter, in world coordinates, with the field array
   * "Actors" (vtkIntArray, the numbers of the two, the lower first), which the block's name says,
   * too. Always the same object, modified when a contact changes.
   */
  vtkMultiBlockDataSet* GetContacts();

  /**
   * Pairs of actors whose boxes meet, in the last Update().
   */
  vtkGetMacro(NumberOfCandidates, int);

  /**
   * Pairs of actors that the last Update() intersected.
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
