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
  constexpr double straight = 1e-5; // sine of the turn
  PlanarPoints corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Vector2d after = ring[(i + 1) % ring.size()] - ring[i];
    if (std::abs (cross (before, after)) > straight * before.norm() * after.norm())
      corners.push_back (ring[i]);
  }
  return corners;
}

/** \brief Finds sides by their first corner. Each side can be taken once. */
class SidesByBegin {
public:
  explicit SidesByBegin (const std::vector<PlanSide>& sides)
  : is_taken_ (sides.size(), 0)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
      by_begin_.emplace (roundedPositionOf (sides[i].from), i);
  }

  /** \return false if the side was taken before */
  bool
  take (std::size_t side)
  {
    if (is_taken_[side] != 0)
      return false;
    is_taken_[side] = 1;
    return true;
  }

  /** \brief Returns a side that begins at \p end and was not taken; nothing if there is
   * none. */
  std::optional<std::size_t>
  untakenFrom (const Vector2d& end) const
  {
    // Coordinates may be rounded apart by one step.
    const auto [x, y] = roundedPositionOf (end);
    for (long long dx = -1; dx <= 1; ++dx)
      for (long long dy = -1; dy <= 1; ++dy)
        if (const auto side = untakenAt ({x + dx, y + dy}))
          return side;
    return {};
  }

private:
  using RoundedPosition = std::pair<long long, long long>;

  static RoundedPosition
  roundedPositionOf (const Vector2d& point)
  {
    constexpr double step = 1e-4; // [m]
    return {std::llround (point.x() / step), std::llround (point.y() / step)};
  }

  std::optional<std::size_t>
  untakenAt (const RoundedPosition& position) const
  {
    const auto [first, last] = by_begin_.equal_range (position);
    for (auto found = first; found != last; ++found)
      if (is_taken_[found->second] == 0)
        return found->second;
    return {};
  }

  std::multimap<RoundedPosition, std::size_t> by_begin_;
  std::vector<char> is_taken_;
};

} // namespace

PlanarRings
ringsOf (const std::vector<PlanSide>& sides)
{
  SidesByBegin left (sides);
  PlanarRings rings;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    PlanarPoints ring;
    for (std::optional<std::size_t> side = i; side && left.take (*side);
         side = left.untakenFrom (sides[*side].to))
      ring.push_back (sides[*side].from);
    if (PlanarPoints corners = withoutStraightCorners (ring); corners.size() >= 3)
      rings.push_back (std::move (corners));
  }
  return rings;
}

} // namespace pcl_ops::internal::buildings
