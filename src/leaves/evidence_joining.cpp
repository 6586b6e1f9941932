// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/evidence_joining.h"

#include "leaves/plane_evidence.h"

#include <algorithm>
#include <cmath>
#include <map>
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
      std::fill (is_to_be_judged_.begin(), is_to_be_judged_.end(), 0);
      for (const Union& both : unions) {
        changed[both.into] = 1;
        changed[both.from] = 1;
        apply (both);
      }
    }
  }

private:
  bool
  isKept (std::int32_t plane) const
  {
    return evidence_[plane] > 0.0;
  }

  // Planes whose evidence may have changed.
  void
  judge ()
  {
    for (const PlaneParts& own : parts_)
      if (is_to_be_judged_[own.number] != 0 && !own.leaves.empty())
        evidence_[own.number] = evidenceOf (cloud_, planes_, surfels_, own);
  }

  /** \brief How many links of a plane lead to each other one; all under no plane. */
  std::map<std::int32_t, double>
  linksOf (const PlaneParts& own) const
  {
    std::map<std::int32_t, double> links;
    for (const std::uint32_t leaf : own.leaves)
      for (const std::uint32_t k : cloud_.neighbors[leaf]) {
        const std::int32_t to = planes_.plane_of_leaf[k];
        if (to == own.number)
          continue;
        links[no_plane] += 1.0;
        if (to != no_plane)
          links[to] += 1.0;
      }
    return links;
  }

  std::vector<Union>
  goodUnions () const
  {
    constexpr double min_share_of_border = 0.1;
    std::vector<Union> good;
    for (const PlaneParts& own : parts_) {
      if (own.leaves.empty() || isKept (own.number))
        continue;
      std::map<std::int32_t, double> links = linksOf (own);
      const double min_links = min_share_of_border * links[no_plane];
      links.erase (no_plane);
      for (const auto& [to, number] : links)
        if (number >= min_links &&
            (is_to_be_judged_[own.number] != 0 || is_to_be_judged_[to] != 0))
          if (const std::optional<double> gain = gainOf (own, parts_[to]))
            good.push_back ({own.number, to, *gain});
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
    is_to_be_judged_[into.number] = 1;
    for (const auto& [to, number] : linksOf (into))
      if (to != no_plane)
        is_to_be_judged_[to] = 1;
  }

  const LeafCloud& cloud_;
  const std::vector<LeafSurfel>& surfels_;
  LeafPlanes& planes_;
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
