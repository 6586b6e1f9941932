// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/evidence_joining.h"

#include "leaves/plane_contacts.h"
#include "leaves/plane_evidence.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace pcl_ops::internal {

namespace {

struct Union {
  std::int32_t into = no_plane;
  std::int32_t from = no_plane;
  double gain = 0.0; // of evidence, above the better part
};

class EvidenceJoining {
public:
  EvidenceJoining (const LeafCloud& cloud,
                   const std::vector<LeafSurfel>& surfels,
                   LeafPlanes& planes)
  : cloud_ (cloud)
  , surfels_ (surfels)
  , planes_ (planes)
  , contacts_ (cloud, planes)
  , parts_ (partsOfPlanes (cloud, planes))
  , evidence_ (parts_.size(), 0.0)
  , is_to_be_judged_ (parts_.size(), 1)
  {}

  /** \return which planes changed */
  std::vector<char>
  joinAll ()
  {
    std::vector<char> changed (parts_.size(), 0);
    while (true) {
      judge();
      const std::vector<Union> unions = chosenUnions();
      if (unions.empty())
        return changed;
      std::vector<char> changed_now (parts_.size(), 0);
      for (const Union& both : unions) {
        apply (both);
        for (const std::int32_t plane : {both.into, both.from}) {
          changed[plane] = 1;
          changed_now[plane] = 1;
        }
      }
      contacts_.update (cloud_, planes_, changed_now);
      markToBeJudged (changed_now);
    }
  }

private:
  bool
  isKept (std::int32_t plane) const
  {
    return evidence_[plane] > 0.0;
  }

  // The evidence of a plane depends on itself and on those it touches.
  void
  markToBeJudged (const std::vector<char>& changed)
  {
    is_to_be_judged_ = changed;
    for (std::size_t plane = 0; plane < changed.size(); ++plane)
      if (changed[plane] != 0)
        for (const PlaneContact* contact = contacts_.begin (plane);
             contact != contacts_.end (plane);
             ++contact)
          is_to_be_judged_[contact->to] = 1;
  }

  void
  judge ()
  {
    for (const PlaneParts& own : parts_)
      if (is_to_be_judged_[own.number] != 0 && !own.leaves.empty())
        evidence_[own.number] = evidenceOf (cloud_, planes_, surfels_, own);
  }

  // Unions that gain, of planes that would not be kept with those they touch along a
  // good part of their border.
  std::vector<Union>
  goodUnions () const
  {
    constexpr double min_share_of_border = 0.1;
    std::vector<Union> good;
    for (const PlaneParts& own : parts_) {
      if (own.leaves.empty() || isKept (own.number))
        continue;
      const double min_links = min_share_of_border * contacts_.border (own.number);
      for (const PlaneContact* contact = contacts_.begin (own.number);
           contact != contacts_.end (own.number);
           ++contact) {
        const std::int32_t to = contact->to;
        const bool is_new =
            is_to_be_judged_[own.number] != 0 || is_to_be_judged_[to] != 0;
        if (!is_new || contact->links < min_links)
          continue;
        if (const std::optional<double> gain = gainOf (own, parts_[to]))
          good.push_back ({own.number, to, *gain});
      }
    }
    return good;
  }

  // Of unions that share a plane the one that gains most.
  std::vector<Union>
  chosenUnions () const
  {
    std::vector<Union> good = goodUnions();
    std::stable_sort (good.begin(), good.end(), [] (const Union& a, const Union& b) {
      return a.gain > b.gain;
    });
    std::vector<char> is_taken (parts_.size(), 0);
    std::vector<Union> chosen;
    for (const Union& both : good) {
      if (is_taken[both.into] != 0 || is_taken[both.from] != 0)
        continue;
      is_taken[both.into] = 1;
      is_taken[both.from] = 1;
      chosen.push_back (both);
    }
    return chosen;
  }

  /** \return nothing where they are two planes, or none together */
  std::optional<double>
  gainOf (const PlaneParts& own, const PlaneParts& other) const
  {
    constexpr double max_noisier = 1.5;
    const std::optional<PlaneParts> both = unionOf (own, other);
    if (!both)
      return std::nullopt;
    const double noise = std::max (meanSquaredDistance (own.moments, own.plane),
                                   meanSquaredDistance (other.moments, other.plane));
    if (meanSquaredDistance (both->moments, both->plane) >
        max_noisier * max_noisier * noise)
      return std::nullopt;
    const double of_better =
        std::max ({0.0, evidence_[own.number], evidence_[other.number]});
    setPlane (other.leaves, own.number);
    const double gain = evidenceOf (cloud_, planes_, surfels_, *both) - of_better;
    setPlane (other.leaves, other.number);
    return gain > 0.0 ? std::optional<double> (gain) : std::nullopt;
  }

  static std::optional<PlaneParts>
  unionOf (const PlaneParts& own, const PlaneParts& other)
  {
    Moments moments = own.moments;
    moments += other.moments;
    const std::optional<PlaneFit> fit = fitPlane (moments);
    if (!fit)
      return std::nullopt;
    PlaneParts both{own.number, fit->plane, {}, moments};
    std::merge (own.leaves.begin(),
                own.leaves.end(),
                other.leaves.begin(),
                other.leaves.end(),
                std::back_inserter (both.leaves));
    return both;
  }

  void
  setPlane (const Indices& leaves, std::int32_t plane) const
  {
    for (const std::uint32_t leaf : leaves)
      planes_.plane_of_leaf[leaf] = plane;
  }

  void
  apply (const Union& both)
  {
    PlaneParts& into = parts_[both.into];
    PlaneParts& from = parts_[both.from];
    into = *unionOf (into, from);
    setPlane (from.leaves, into.number);
    from.leaves.clear();
    planes_.planes[into.number] = into.plane;
  }

  const LeafCloud& cloud_;
  const std::vector<LeafSurfel>& surfels_;
  LeafPlanes& planes_;
  PlaneContacts contacts_;
  std::vector<PlaneParts> parts_;
  std::vector<double> evidence_;
  std::vector<char> is_to_be_judged_;
};

} // namespace

std::vector<char>
joinByEvidence (const LeafCloud& cloud,
                const std::vector<LeafSurfel>& surfels,
                LeafPlanes& planes)
{
  return EvidenceJoining (cloud, surfels, planes).joinAll();
}

} // namespace pcl_ops::internal
