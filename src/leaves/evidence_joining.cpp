// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/evidence_joining.h"

#include "base/parallel.h"
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
                   unsigned threads,
                   LeafPlanes& planes)
  : cloud_ (cloud)
  , surfels_ (surfels)
  , threads_ (threads)
  , planes_ (planes)
  , contacts_ (cloud, planes, threads, ContactSums::Links)
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
      // That of those that touch them changes too little to be asked for again.
      is_to_be_judged_ = std::move (changed_now);
    }
  }

private:
  bool
  isKept (std::int32_t plane) const
  {
    return evidence_[plane] > 0.0;
  }

  void
  judge ()
  {
    Labels judged;
    for (const PlaneParts& own : parts_)
      if (is_to_be_judged_[own.number] != 0 && !own.leaves.empty())
        judged.push_back (own.number);
    parallelFor (threads_, judged.size(), 1, [&] (std::size_t i, std::size_t) {
      evidence_[judged[i]] = evidenceOf (cloud_, planes_, surfels_, parts_[judged[i]]);
    });
  }

  // Planes that would not be kept, with those they touch along a good part of their
  // border, where either has changed.
  std::vector<Union>
  possibleUnions () const
  {
    constexpr double min_share_of_border = 0.1;
    std::vector<Union> possible;
    for (const PlaneParts& own : parts_) {
      if (own.leaves.empty() || isKept (own.number))
        continue;
      const double min_links = min_share_of_border * contacts_.border (own.number);
      for (const PlaneContact* contact = contacts_.begin (own.number);
           contact != contacts_.end (own.number);
           ++contact) {
        const bool is_new =
            is_to_be_judged_[own.number] != 0 || is_to_be_judged_[contact->to] != 0;
        if (is_new && contact->links >= min_links)
          possible.push_back ({own.number, contact->to});
      }
    }
    return possible;
  }

  // Unions that gain.
  std::vector<Union>
  goodUnions () const
  {
    std::vector<Union> unions = possibleUnions();
    parallelFor (threads_, unions.size(), 1, [&] (std::size_t i, std::size_t) {
      unions[i].gain = gainOf (parts_[unions[i].into], parts_[unions[i].from]);
    });
    unions.erase (std::remove_if (unions.begin(),
                                  unions.end(),
                                  [] (const Union& both) { return both.gain <= 0.0; }),
                  unions.end());
    return unions;
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

  /** \return 0 where they are two planes, or none together */
  double
  gainOf (const PlaneParts& own, const PlaneParts& other) const
  {
    constexpr double max_noisier = 1.5;
    const std::optional<Plane> plane = planeOfBoth (own, other);
    if (!plane)
      return 0.0;
    const double noise = std::max (meanSquaredDistance (own.moments, own.plane),
                                   meanSquaredDistance (other.moments, other.plane));
    if (meanSquaredDistance (momentsOfBoth (own, other), *plane) >
        max_noisier * max_noisier * noise)
      return 0.0;
    const double of_better =
        std::max ({0.0, evidence_[own.number], evidence_[other.number]});
    return std::max (
        0.0,
        evidenceOf (cloud_, planes_, surfels_, unionOf (own, other, *plane)) -
            of_better);
  }

  static Moments
  momentsOfBoth (const PlaneParts& own, const PlaneParts& other)
  {
    Moments moments = own.moments;
    moments += other.moments;
    return moments;
  }

  static std::optional<Plane>
  planeOfBoth (const PlaneParts& own, const PlaneParts& other)
  {
    const std::optional<PlaneFit> fit = fitPlane (momentsOfBoth (own, other));
    return fit ? std::optional<Plane> (fit->plane) : std::nullopt;
  }

  static Indices
  merged (const Indices& own, const Indices& other)
  {
    Indices both;
    both.reserve (own.size() + other.size());
    std::merge (
        own.begin(), own.end(), other.begin(), other.end(), std::back_inserter (both));
    return both;
  }

  static PlaneParts
  unionOf (const PlaneParts& own, const PlaneParts& other, const Plane& plane)
  {
    return {own.number,
            plane,
            momentsOfBoth (own, other),
            merged (own.leaves, other.leaves),
            merged (own.border_leaves, other.border_leaves),
            other.number};
  }

  void
  apply (const Union& both)
  {
    PlaneParts& into = parts_[both.into];
    PlaneParts& from = parts_[both.from];
    into = unionOf (into, from, planeOfBoth (into, from).value());
    into.other_number = no_plane;
    for (const std::uint32_t leaf : from.leaves)
      planes_.plane_of_leaf[leaf] = into.number;
    from.leaves.clear();
    planes_.planes[into.number] = into.plane;
  }

  const LeafCloud& cloud_;
  const std::vector<LeafSurfel>& surfels_;
  unsigned threads_;
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
                unsigned threads,
                LeafPlanes& planes)
{
  return EvidenceJoining (cloud, surfels, threads, planes).joinAll();
}

} // namespace pcl_ops::internal
