// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include "ops/oriented_points.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The paper's sampling: points drawn at random, with the normals of their
 * nearest neighbours; planes do not end. */
class DrawnPoints {
public:
  /** \brief P_s, and where the neighbours of its points are found. */
  struct Samples {
    Indices points;
    NeighbourSearch search;
  };

  /** \param[in] input, parameters used as long as this is */
  DrawnPoints (const DetectorInput& input,
               const OrientedPointSamplingParameters& parameters)
  : input_ (input), parameters_ (parameters)
  {}

  Samples
  sample (const Points& points) const;

  OrientedSamples
  orient (const Points& points, const Samples& samples) const;

  /** \return planes in the order found */
  std::vector<Plane>
  extract (const Points& points,
           const Samples& samples,
           const OrientedSamples& oriented) const;

  /** \brief Nothing: drawn points do not tell where planes end. */
  void
  bound (const Points& /*points*/,
         const Samples& /*samples*/,
         const std::vector<Plane>& /*planes*/) const
  {}

  AssignedPoints
  assign (const Points& points,
          const Samples& samples,
          const std::vector<Plane>& planes) const;

  LabelledPlanes
  merge (AssignedPoints assigned) const;

private:
  const DetectorInput& input_;
  const OrientedPointSamplingParameters& parameters_;
};

} // namespace pcl_ops::internal
