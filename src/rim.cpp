// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rim.h"

#include "planar_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops {

namespace {

bool
comesFirst (const Eigen::Vector2d& first, const Eigen::Vector2d& second)
{
  return first.x() < second.x() || (first.x() == second.x() && first.y() < second.y());
}

PlanarPoints
sorted (PlanarPoints points)
{
  std::sort (points.begin(), points.end(), comesFirst);
  return points;
}

bool
isAmong (const PlanarPoints& ordered, const Eigen::Vector2d& point)
{
  return std::binary_search (ordered.begin(), ordered.end(), point, comesFirst);
}

/** \brief How far inside a convex hull each point lies, above 0 within. */
std::vector<double>
depthsWithin (const PlanarPoints& hull, const PlanarPoints& points)
{
  std::vector<double> depths (points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t e = 0; e < hull.size(); ++e) {
    const Eigen::Vector2d edge = (hull[(e + 1) % hull.size()] - hull[e]).normalized();
    const Eigen::Vector2d inwards (-edge.y(), edge.x());
    const double offset = inwards.dot (hull[e]);
    for (std::size_t i = 0; i < points.size(); ++i)
      depths[i] = std::min (depths[i], inwards.dot (points[i]) - offset);
  }
  return depths;
}

} // namespace

std::size_t
Rim::takeOff (const PlanarPoints& hull)
{
  const PlanarPoints corners = sorted (hull);
  const auto is_corner = [&] (const Eigen::Vector2d& point) {
    return isAmong (corners, point);
  };
  if (outer_.empty() || std::any_of (inner_hull_.begin(), inner_hull_.end(), is_corner))
    splitNear (hull);
  const std::size_t before = outer_.size();
  outer_.erase (std::remove_if (outer_.begin(), outer_.end(), is_corner), outer_.end());
  return before - outer_.size();
}

PlanarPoints
Rim::hull() const
{
  PlanarPoints points = outer_;
  points.insert (points.end(), inner_hull_.begin(), inner_hull_.end());
  return hullOfAll (points);
}

void
Rim::splitNear (const PlanarPoints& hull)
{
  inner_.insert (inner_.end(), outer_.begin(), outer_.end());
  outer_.clear();
  const std::vector<double> depths = depthsWithin (hull, inner_);
  constexpr std::size_t one_in = 32;
  std::vector<double> ordered = depths;
  const auto nth =
      ordered.begin() + static_cast<std::ptrdiff_t> (ordered.size() / one_in);
  std::nth_element (ordered.begin(), nth, ordered.end());
  // The hull's own corners are a rounding away from depth 0.
  constexpr double rounding = 1e-12;
  const double near = *nth + rounding * (1.0 + std::abs (hull.front().sum()));
  PlanarPoints inner;
  for (std::size_t i = 0; i < inner_.size(); ++i)
    (depths[i] <= near ? outer_ : inner).push_back (inner_[i]);
  inner_.swap (inner);
  inner_hull_ = hullOfAll (inner_);
}

} // namespace pcl_ops
