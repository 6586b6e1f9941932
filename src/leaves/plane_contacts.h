// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief What two planes have in common where they touch: sums over the pairs of
 * touching leaves, one of either plane. */
struct PlaneContact {
  std::int32_t from = no_plane, to = no_plane;
  /** \brief Pairs of leaves. */
  double links = 0.0;
  /** \brief Squared noise of \p to there [m^2]. */
  double squared_noise = 0.0;
  /** \brief Mean squared distance of either's leaves to the other plane [m^2]. */
  double squared_distance = 0.0;
  /** \brief Squared scatter of either's leaves about the plane of those around: noise
   * without what bends or joins the plane [m^2]. */
  double squared_grain = 0.0;
};

/** \brief What is summed of contacts: their number is enough to tell which planes touch
 * along much of their border. */
enum class ContactSums { Links, All };

/** \brief The contacts of all planes. They live through all passes of joining: links
 * only disappear, and only contacts of planes that have changed are summed again. */
class PlaneContacts {
public:
  PlaneContacts (const LeafCloud& cloud,
                 const LeafPlanes& planes,
                 unsigned threads,
                 ContactSums sums = ContactSums::All);

  /** \brief Sums the contacts of planes that have changed. */
  void
  update (const LeafCloud& cloud,
          const LeafPlanes& planes,
          const std::vector<char>& changed);

  /** \brief Of a plane, by the number of the other. */
  const PlaneContact*
  begin (std::size_t plane) const
  {
    return contacts_.data() + first_[plane];
  }
  const PlaneContact*
  end (std::size_t plane) const
  {
    return contacts_.data() + first_[plane + 1];
  }

  /** \brief Pairs of leaves along the border of a plane; those with leaves without a
   * plane count half. */
  double
  border (std::size_t plane) const
  {
    return border_[plane];
  }

private:
  struct Link {
    std::uint32_t leaf, neighbor;
  };

  /** \brief Drops links within planes and counts the rest. */
  void
  dropInnerLinks (const LeafPlanes& planes);

  /** \brief Sums the links that have to be. */
  void
  addLinks (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const std::vector<char>& changed);

  /** \brief Measures the grain of leaves of links where it is not known. */
  void
  measureGrain (const LeafCloud& cloud,
                const LeafPlanes& planes,
                const std::vector<Link>& links);

  /** \brief What each link adds to the contact of its planes. */
  std::vector<PlaneContact>
  measured (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const std::vector<Link>& links);

  unsigned threads_;
  ContactSums sums_;
  std::vector<Link> links_;
  std::vector<PlaneContact> contacts_;
  std::vector<std::size_t> first_;
  std::vector<double> border_;
  std::vector<double> squared_grain_; // of leaves; below 0: not known
};

} // namespace pcl_ops::internal
