// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/random.h"
#include "geometry/points.h"
#include <pcl_ops/plane.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

/** \brief N_iter = log (1 - p) / log (1 - w): draws of one point after which an inlier
 * was among them with probability p.
 * \param[in] probability p in (0, 1)
 * \param[in] inlier_ratio w = 1 - e; outside (0, 1) it is guarded: w >= 1 needs one
 * draw, w <= 0 as many as fit */
std::size_t
requiredDraws (double probability, double inlier_ratio);

/** \brief How well a hypothesis does. */
struct Vote {
  /** \brief What hypotheses compete by. */
  std::int32_t weight = 0;
  std::int32_t inliers = 0;
  /** \brief N_h: how many could have been inliers. */
  std::size_t voters = 0;

  /** \brief w = inliers / N_h */
  double
  inlierRatio () const
  {
    return static_cast<double> (inliers) / static_cast<double> (voters);
  }
};

/** \brief The hypothesis with the largest weight: a sample's own plane, drawn N_iter
 * times, N_iter adapted to the best inlier ratio so far (Algorithm 1, lines 7 to 24).
 * \tparam Samples what planes are found among: \c size () of them, whether they
 * \c mayHoldPlane (), the \c planeOf (i) each stands for, a \c vote (plane) for it,
 * whether that \c suffices (plane, vote), and \c leastVote (), to be exceeded
 * \param[in] samples the samples no plane has yet
 * \param[in] probability p
 * \param[in,out] generator source of the draws
 * \return nothing if no vote suffices */
template <typename Samples>
std::optional<Plane>
onePointRansac (const Samples& samples, double probability, RandomGenerator& generator)
{
  if (!samples.mayHoldPlane())
    return std::nullopt;
  std::optional<Plane> best;
  // No plane smaller than theta_N is worth a draw: the cap of a round that finds
  // nothing.
  Vote best_vote = samples.leastVote();
  std::size_t n_iter = requiredDraws (probability, best_vote.inlierRatio());
  for (std::size_t iter = 0; iter < n_iter; ++iter) {
    const std::uint32_t drawn =
        drawBelow (generator, static_cast<std::uint32_t> (samples.size()));
    const Plane& hypothesis = samples.planeOf (drawn);
    const Vote vote = samples.vote (hypothesis);
    if (vote.weight <= best_vote.weight || !samples.suffices (hypothesis, vote))
      continue;
    best = hypothesis;
    best_vote = vote;
    n_iter = requiredDraws (probability, vote.inlierRatio());
  }
  return best;
}

/** \brief What is on a plane. */
struct Support {
  Plane plane;
  Indices inliers;
  Moments moments;
};

/** \brief Local optimisation: the plane refitted to its support is kept as long as it
 * finds more points (LO-RANSAC, Chum, Matas & Kittler 2003).
 * \param[in] select (plane) -> Support */
template <typename Select>
Support
growSupport (const Plane& hypothesis, Select&& select)
{
  Support support = select (hypothesis);
  while (const std::optional<PlaneFit> fit = fitPlane (support.moments)) {
    Support selected = select (fit->plane);
    if (selected.moments.count <= support.moments.count)
      break;
    support = std::move (selected);
  }
  return support;
}

/** \brief What a turn of the peel loop takes away: the inliers of a plane, or what
 * looked like a plane and is none. */
struct Peel {
  Indices taken;
  std::optional<Plane> plane;
};

/** \brief A plane with the samples on it. */
struct ExtractedPlane {
  Plane plane;
  Indices inliers;
};

/** \brief The peel loop (paper, "Detection of Multiple Planes"): finds the largest
 * plane, removes its inliers and repeats until none is found. \param[in,out] samples \c
 * remove (taken) takes from them; what no plane has is left \param[in] find_largest
 * (samples) -> std::optional<Peel> \return the planes in the order found; their inliers
 * are disjoint */
template <typename Samples, typename FindLargest>
std::vector<ExtractedPlane>
extractAll (Samples& samples, FindLargest&& find_largest)
{
  std::vector<ExtractedPlane> planes;
  while (std::optional<Peel> found = find_largest (samples)) {
    const std::size_t before = samples.size();
    samples.remove (*found);
    if (samples.size() == before)
      break;
    if (found->plane)
      planes.push_back ({*found->plane, std::move (found->taken)});
  }
  return planes;
}

} // namespace pcl_ops::internal
