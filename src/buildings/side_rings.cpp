// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "side_rings.h"

#include "planar_area.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace pcl_ops::internal::buildings {
namespace {

using Eigen::Vector2d;

/** \brief Returns a ring without the corners at which it does not turn. */
PlanarPoints
withoutStraightCorners (const PlanarPoints& ring)
{
  constexpr double max_sine_of_no_turn = 1e-5; // chosen by hand
  PlanarPoints corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Vector2d after = ring[(i + 1) % ring.size()] - ring[i];
    if (std::abs (cross (before, after)) >
        max_sine_of_no_turn * before.norm() * after.norm())
      corners.push_back (ring[i]);
  }
  return corners;
}

/** \brief Finds sides by the corner where they begin. Each side can be taken once. */
class SidesByBegin {
public:
  explicit SidesByBegin (const std::vector<PlanSide>& sides)
  : is_taken_ (sides.size(), 0)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
      by_begin_.emplace (roundedPositionOf (sides[i].from), i);
  }

  /** \brief Takes the side with index \p side.
   * \return false if it was taken before */
  bool
  take (std::size_t side)
  {
    if (is_taken_[side] != 0)
      return false;
    is_taken_[side] = 1;
    return true;
  }

  /** \brief Returns the index of a side that begins at \p corner and was not taken;
   * nothing if there is none. */
  std::optional<std::size_t>
  untakenFrom (const Vector2d& corner) const
  {
    // The two ends at one corner may be rounded apart by one step in x and in y.
    const auto [x, y] = roundedPositionOf (corner);
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy)
        if (const auto side = untakenAt ({x + dx, y + dy}))
          return side;
    return {};
  }

private:
  /** \brief x and y in steps of 0.1 mm. */
  using RoundedPosition = std::pair<long long, long long>;

  static RoundedPosition
  roundedPositionOf (const Vector2d& point)
  {
    constexpr double step = 1e-4; // [m], chosen by hand
    return {std::llround (point.x() / step), std::llround (point.y() / step)};
  }

  std::optional<std::size_t>
  untakenAt (const RoundedPosition& position) const
  {
    const auto [first, last] = by_begin_.equal_range (position);
    for (auto entry = first; entry != last; ++entry) {
      const std::size_t side = entry->second;
      if (is_taken_[side] == 0)
        return side;
    }
    return {};
  }

  std::multimap<RoundedPosition, std::size_t> by_begin_; // indices of sides
  std::vector<char> is_taken_;
};

} // namespace

PlanarRings
ringsOf (const std::vector<PlanSide>& sides)
{
  SidesByBegin untaken (sides);
  PlanarRings rings;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    PlanarPoints ring;
    for (std::optional<std::size_t> side = i; side && untaken.take (*side);
         side = untaken.untakenFrom (sides[*side].to))
      ring.push_back (sides[*side].from);
    if (PlanarPoints corners = withoutStraightCorners (ring); corners.size() >= 3)
      rings.push_back (std::move (corners));
  }
  return rings;
}

} // namespace pcl_ops::internal::buildings
