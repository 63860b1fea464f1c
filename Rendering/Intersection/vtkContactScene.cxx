// SPDX-FileCopyrightText: Copyright (c) The Relevo developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactScene.h"

#include "Checks/MemoryGuard.h"
#include "Checks/SettingChecks.h"
#include "Scene/ActorPair.h"
#include "Scene/CandidateMetrics.h"
#include "Scene/SceneActor.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkContactScene);

namespace
{
using ActorList = std::vector<std::unique_ptr<relevo::SceneActor>>;
using Pair = std::pair<int, int>;

// The intersection of two actors, with their indices.
struct Contact
{
  bool operator==(const Contact& other) const
  {
    return this->Numbers == other.Numbers && this->Curves == other.Curves;
  }

  Pair Numbers;
  vtkSmartPointer<vtkPolyData> Curves;
};

// Find the pairs by a sweep along x.
std::vector<Pair> FindCandidates(const ActorList& actors)
{
  std::vector<int> order;
  for (std::size_t i = 0; i < actors.size(); ++i)
  {
    if (actors[i]->HasBox())
    {
      order.push_back(static_cast<int>(i));
    }
  }
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return actors[a]->GetBox()[0] < actors[b]->GetBox()[0]; });
  std::vector<Pair> candidates;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const relevo::Bounds& box = actors[order[i]]->GetBox();
    for (std::size_t j = i + 1; j < order.size(); ++j)
    {
      const relevo::Bounds& other = actors[order[j]]->GetBox();
      if (other[0] > box[1])
      {
        break;
      }
      if (relevo::HaveCommonBox(box, other))
      {
        candidates.emplace_back(std::minmax(order[i], order[j]));
      }
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

vtkSmartPointer<vtkPolyData> MakeBlock(const Contact& contact)
{
  auto block = vtkSmartPointer<vtkPolyData>::New();
  block->ShallowCopy(contact.Curves);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Actors");
  numbers->InsertNextValue(contact.Numbers.first);
  numbers->InsertNextValue(contact.Numbers.second);
  block->GetFieldData()->AddArray(numbers);
  return block;
}

std::string GetName(const Pair& numbers)
{
  return "Actors " + std::to_string(numbers.first) + " and " + std::to_string(numbers.second);
}
}

struct vtkContactScene::Internals
{
  ActorList::iterator Find(vtkActor* actor)
  {
    return std::find_if(this->Actors.begin(), this->Actors.end(),
      [actor](const auto& item) { return item->GetActor() == actor; });
  }
  void FillBlocks();

  ActorList Actors;
  relevo::CandidateMetrics Metrics;
  std::map<std::pair<vtkActor*, vtkActor*>, relevo::ActorPair> Pairs;
  std::vector<Contact> Contacts;
  vtkNew<vtkMultiBlockDataSet> Blocks;
};

void vtkContactScene::Internals::FillBlocks()
{
  this->Blocks->Initialize();
  this->Blocks->SetNumberOfBlocks(static_cast<unsigned int>(this->Contacts.size()));
  for (unsigned int i = 0; i < this->Blocks->GetNumberOfBlocks(); ++i)
  {
    this->Blocks->SetBlock(i, MakeBlock(this->Contacts[i]));
    this->Blocks->GetMetaData(i)->Set(
      vtkCompositeDataSet::NAME(), GetName(this->Contacts[i].Numbers).c_str());
  }
  this->Blocks->Modified();
}

vtkContactScene::vtkContactScene()
  : Scene(new Internals)
{
}

vtkContactScene::~vtkContactScene() = default;

void vtkContactScene::AddActor(vtkActor* actor)
{
  if (!actor)
  {
    vtkErrorMacro("Cannot add the actor: it is null.");
    return;
  }
  if (this->Scene->Find(actor) != this->Scene->Actors.end())
  {
    vtkErrorMacro("Cannot add the actor: it is already in the scene.");
    return;
  }
  this->Scene->Actors.push_back(std::make_unique<relevo::SceneActor>(actor));
  this->Modified();
}

void vtkContactScene::RemoveActor(vtkActor* actor)
{
  const auto found = this->Scene->Find(actor);
  if (found == this->Scene->Actors.end())
  {
    return;
  }
  for (auto pair = this->Scene->Pairs.begin(); pair != this->Scene->Pairs.end();)
  {
    const bool isOf = pair->first.first == actor || pair->first.second == actor;
    pair = isOf ? this->Scene->Pairs.erase(pair) : std::next(pair);
  }
  this->Scene->Actors.erase(found);
  this->Modified();
}

void vtkContactScene::RemoveAllActors()
{
  while (this->GetNumberOfActors() > 0)
  {
    this->RemoveActor(this->GetActor(this->GetNumberOfActors() - 1));
  }
}

int vtkContactScene::GetNumberOfActors()
{
  return static_cast<int>(this->Scene->Actors.size());
}

vtkActor* vtkContactScene::GetActor(int index)
{
  const bool isThere = index >= 0 && index < this->GetNumberOfActors();
  return isThere ? this->Scene->Actors[index]->GetActor() : nullptr;
}

void vtkContactScene::SetDistance(double distance)
{
  relevo::SetInRange(this, "Distance", this->Distance, distance, 0.0, relevo::LargestDouble);
}

void vtkContactScene::SetTolerance(double tolerance)
{
  relevo::SetInRange(this, "Tolerance", this->Tolerance, tolerance, 0.0, relevo::LargestDouble);
}

void vtkContactScene::Update()
{
  relevo::RunWithinMemory(this, "the contacts of the actors",
    [&]
    {
      this->FindContacts();
      return true;
    });
}

void vtkContactScene::FindContacts()
{
  Internals& scene = *this->Scene;
  scene.Metrics.Begin(this->Distance);
  for (const auto& actor : scene.Actors)
  {
    actor->Update();
    scene.Metrics.AddActor(actor->GetActor());
  }
  const std::vector<Pair> candidates = FindCandidates(scene.Actors);
  this->NumberOfCandidates = static_cast<int>(candidates.size());
  this->NumberOfIntersections = 0;
  std::vector<Contact> contacts;
  for (const Pair& numbers : candidates)
  {
    const relevo::SceneActor& first = *scene.Actors[numbers.first];
    const relevo::SceneActor& second = *scene.Actors[numbers.second];
    const relevo::Bounds box = relevo::GetCommonBox(first.GetBox(), second.GetBox());
    scene.Metrics.AddBox(first.GetActor(), box);
    scene.Metrics.AddBox(second.GetActor(), box);
    if (!this->ExactContacts || !first.GetSurface() || !second.GetSurface())
    {
      continue;
    }
    relevo::ActorPair& pair = scene.Pairs[{ first.GetActor(), second.GetActor() }];
    if (pair.Update(first, second, this->RefinedContacts, this->Tolerance))
    {
      ++this->NumberOfIntersections;
      this->Report(GetName(numbers), pair.GetNewErrors(), pair.GetNewWarnings());
    }
    if (pair.GetCurves())
    {
      contacts.push_back({ numbers, pair.GetCurves() });
    }
  }
  scene.Metrics.End();
  if (scene.Contacts != contacts)
  {
    scene.Contacts = std::move(contacts);
    scene.FillBlocks();
  }
}

void vtkContactScene::Report(
  const std::string& pair, const std::string& errors, const std::string& warnings)
{
  if (!errors.empty())
  {
    vtkErrorMacro(<< pair << " cannot be intersected: " << errors);
  }
  if (!warnings.empty())
  {
    vtkWarningMacro(<< pair << ", inputs 0 and 1: " << warnings);
  }
}

vtkMultiBlockDataSet* vtkContactScene::GetContacts()
{
  return this->Scene->Blocks;
}

void vtkContactScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfActors: " << this->GetNumberOfActors() << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "ExactContacts: " << this->ExactContacts << "\n";
  os << indent << "RefinedContacts: " << this->RefinedContacts << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfCandidates: " << this->NumberOfCandidates << "\n";
  os << indent << "NumberOfIntersections: " << this->NumberOfIntersections << "\n";
}
