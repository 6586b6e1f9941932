// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/cell_scatter.h"

#include <array>
#include <vector>

namespace pcl_ops::internal {

/** \brief The noise that planes of a cloud may be expected to have, known before any
 * plane is: what the flattest tenth of all cells scatters by, by the density of their
 * points and by their size.
 *
 * White noise (lidar, survey) is the same for all sizes, correlated noise (a smoothed
 * depth image, a fused mesh) grows slowly with the size. What grows as fast as the size
 * is structure: bends, hills, furniture. Quantized depth has no noise up to the size of
 * a step, where nothing is known. */
class ExpectedNoise {
public:
  /** \param[in] cell_size edge of the finest cells [m] */
  ExpectedNoise (const std::vector<CellScatter>& cells, double cell_size);

  /** \brief Of a plane of so many points where points are as dense as that [m]. Larger
   * than any cloud where no cell tells.
   * \param[in] density \ref densityOf */
  double
  of (double density, double points) const;

  /** \brief Whether cells told what \ref of gives. */
  static bool
  isKnown (double noise);

  /** \brief No more than \ref of gives for any number of points: cheap to compare
   * with. */
  double
  lowest (double density) const;

  /** \brief Whether points as dense as that scatter in cells of a level by what is
   * noise: in larger cells no more than twice as much, level by level up to this one.
   * What grows faster is structure of the surface. */
  bool
  isNoise (double density, int level) const;

private:
  /** \brief Densities are told apart by factors of two. */
  static constexpr int classes = 128;

  /** \brief Of one density: logarithms (base 2) of the noise of cells by level. */
  struct Curve {
    int finest = -1, coarsest = -1; // -1: not known
    std::array<float, top_level + 1> noise{};
    float lowest = 0.0f;

    bool
    isKnown () const
    {
      return finest >= 0;
    }

    float
    at (double level) const;
  };

  static Curve
  curveOf (std::array<std::vector<float>, top_level + 1>& noise_of_level, double cell);

  /** \brief The nearest class that has a curve, of two the lower; \p own where none
   * has. */
  static int
  nearestKnown (const std::vector<Curve>& curves, int own);

  /** \brief Classes without a curve take the nearest one. */
  void
  fillGaps ();

  std::vector<Curve> curves_;
};

} // namespace pcl_ops::internal
