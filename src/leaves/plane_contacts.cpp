// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/plane_contacts.h"

#include "geometry/principal_axes.h"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

namespace pcl_ops::internal {

namespace {

constexpr double unknown_grain = -1.0;

// Mean squared distance of the leaves of a plane around a leaf to the plane through
// them.
double
measuredGrain (const LeafCloud& cloud, const LeafPlanes& planes, std::uint32_t leaf)
{
  Moments around;
  for (const std::uint32_t k : cloud.neighbors[leaf])
    if (planes.plane_of_leaf[k] == planes.plane_of_leaf[leaf])
      around.addAligned (cloud.moments[k]);
  const double least = cloud.min_noise[leaf] * cloud.min_noise[leaf];
  if (around.count <= 3.0)
    return least;
  const double variance = principalAxes (around.covariance()).values[0];
  return std::max (least, variance * around.count / (around.count - 3.0));
}

bool
precedes (const PlaneContact& a, const PlaneContact& b)
{
  return std::make_pair (a.from, a.to) < std::make_pair (b.from, b.to);
}

/** \brief Contacts by their planes, in the order in which they are asked for. */
class ContactsByPlanes {
public:
  explicit ContactsByPlanes (std::vector<PlaneContact>& contacts) : contacts_ (contacts)
  {}

  PlaneContact&
  operator() (std::int32_t from, std::int32_t to)
  {
    // Links that follow each other are mostly of the same planes.
    if (last_ < contacts_.size() && contacts_[last_].from == from &&
        contacts_[last_].to == to)
      return contacts_[last_];
    const std::uint64_t key =
        static_cast<std::uint64_t> (from) << 32 | static_cast<std::uint32_t> (to);
    const auto [place, is_new] = place_.try_emplace (key, contacts_.size());
    if (is_new)
      contacts_.push_back ({from, to});
    last_ = place->second;
    return contacts_[last_];
  }

private:
  std::vector<PlaneContact>& contacts_;
  std::unordered_map<std::uint64_t, std::size_t> place_ = {};
  std::size_t last_ = std::numeric_limits<std::size_t>::max();
};

} // namespace

PlaneContacts::PlaneContacts (const LeafCloud& cloud,
                              const LeafPlanes& planes,
                              ContactSums sums)
: sums_ (sums), squared_grain_ (cloud.size(), unknown_grain)
{
  for (std::uint32_t leaf = 0; leaf < cloud.size(); ++leaf) {
    const std::int32_t plane = planes.plane_of_leaf[leaf];
    if (plane == no_plane)
      continue;
    for (const std::uint32_t k : cloud.neighbors[leaf])
      if (planes.plane_of_leaf[k] != plane)
        links_.push_back ({leaf, k});
  }
  update (cloud, planes, std::vector<char> (planes.planes.size(), 1));
}

void
PlaneContacts::update (const LeafCloud& cloud,
                       const LeafPlanes& planes,
                       const std::vector<char>& changed)
{
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (planes.plane_of_leaf[i] != no_plane && changed[planes.plane_of_leaf[i]] != 0)
      squared_grain_[i] = unknown_grain;
  dropInnerLinks (planes);
  contacts_.erase (std::remove_if (contacts_.begin(),
                                   contacts_.end(),
                                   [&] (const PlaneContact& contact) {
                                     return changed[contact.from] != 0 ||
                                            changed[contact.to] != 0;
                                   }),
                   contacts_.end());
  addLinks (cloud, planes, changed);
  first_.assign (planes.planes.size() + 1, 0);
  for (const PlaneContact& contact : contacts_)
    ++first_[contact.from + 1];
  for (std::size_t p = 0; p < planes.planes.size(); ++p)
    first_[p + 1] += first_[p];
}

void
PlaneContacts::dropInnerLinks (const LeafPlanes& planes)
{
  constexpr double weight_of_open = 0.5;
  border_.assign (planes.planes.size(), 0.0);
  std::size_t kept = 0;
  for (const Link& link : links_) {
    const std::int32_t from = planes.plane_of_leaf[link.leaf];
    const std::int32_t to = planes.plane_of_leaf[link.neighbor];
    if (from == to)
      continue;
    border_[from] += to == no_plane ? weight_of_open : 1.0;
    links_[kept] = link;
    ++kept;
  }
  links_.resize (kept);
}

double
PlaneContacts::squaredGrain (const LeafCloud& cloud,
                             const LeafPlanes& planes,
                             std::uint32_t leaf)
{
  if (squared_grain_[leaf] < 0.0)
    squared_grain_[leaf] = measuredGrain (cloud, planes, leaf);
  return squared_grain_[leaf];
}

void
PlaneContacts::addMeasures (const LeafCloud& cloud,
                            const LeafPlanes& planes,
                            const Link& link,
                            PlaneContact& contact)
{
  const auto& [leaf, neighbor] = link;
  const double noise = planes.noise[neighbor];
  contact.squared_noise += noise * noise;
  contact.squared_distance +=
      0.5 *
      (meanSquaredDistance (cloud.moments[neighbor], planes.planes[contact.from]) +
       meanSquaredDistance (cloud.moments[leaf], planes.planes[contact.to]));
  contact.squared_grain += 0.5 * (squaredGrain (cloud, planes, leaf) +
                                  squaredGrain (cloud, planes, neighbor));
}

void
PlaneContacts::addLinks (const LeafCloud& cloud,
                         const LeafPlanes& planes,
                         const std::vector<char>& changed)
{
  std::vector<PlaneContact> added;
  ContactsByPlanes contactOf (added);
  // Sums of a pair are taken in the order of the leaves.
  for (const Link& link : links_) {
    const std::int32_t from = planes.plane_of_leaf[link.leaf];
    const std::int32_t to = planes.plane_of_leaf[link.neighbor];
    if (to == no_plane || (changed[from] == 0 && changed[to] == 0))
      continue;
    PlaneContact& contact = contactOf (from, to);
    contact.links += 1.0;
    if (sums_ == ContactSums::All)
      addMeasures (cloud, planes, link, contact);
  }
  contacts_.insert (contacts_.end(), added.begin(), added.end());
  std::sort (contacts_.begin(), contacts_.end(), precedes);
}

} // namespace pcl_ops::internal
