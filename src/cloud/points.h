// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::detail {}

namespace pcl_ops::internal {

// What the public headers need of the library, too, has its names here.
using namespace detail;

/** \brief Positions in space as a structure of arrays, in single precision. */
struct Coordinates {
  std::vector<float> x, y, z;

  std::size_t
  size () const
  {
    return x.size();
  }

  Eigen::Vector3d
  operator[] (std::size_t i) const
  {
    return Eigen::Vector3d (x[i], y[i], z[i]);
  }

  void
  resize (std::size_t size)
  {
    x.resize (size);
    y.resize (size);
    z.resize (size);
  }

  void
  add (float px, float py, float pz)
  {
    x.push_back (px);
    y.push_back (py);
    z.push_back (pz);
  }
};

/** \brief A point that another one at its place stands for. */
struct Copy {
  /** \brief Of the input cloud. */
  pcl::index_t index;
  /** \brief The number of the one that stands for it. */
  std::uint32_t point;
};

/** \brief The finite points a detector works on. Their coordinates are relative to
 * \ref origin: single precision is enough however far the cloud is from its zero. */
struct Points : Coordinates {
  /** \brief Zero of the local frame, in the frame of the input cloud. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Index of each point in the input cloud; ascending, each once. Empty where
   * the points are the whole cloud, as they mostly are: see \ref indexOf. */
  pcl::Indices index;
  /** \brief By rising indices; none but of \ref distinctPoints. */
  std::vector<Copy> copies;

  pcl::index_t
  indexOf (std::size_t point) const
  {
    return index.empty() ? static_cast<pcl::index_t> (point) : index[point];
  }
};

/** \brief Numbers of a stage's own items: points, voxels or samples. Of the input
 * cloud's points pcl::Indices speak. */
using Indices = std::vector<std::uint32_t>;

/** \brief Some of the points, in the order of their numbers. */
Coordinates
selected (const Coordinates& points, const Indices& numbers);

/** \brief About so many of the points, the same ones whatever their order. */
Coordinates
samplePoints (const Coordinates& positions, std::size_t wanted);

/** \brief The numbers of about so many of the points, ascending, the same points
 * whatever their order; none that are not finite. */
Indices
sampleNumbers (const Coordinates& positions, std::size_t wanted);

/** \brief The median, or the upper of two middle ones; 0 for no values. Reorders. */
double
medianOf (std::vector<float>& values);

/** \brief Drops points with a NaN or infinite coordinate, once and for all stages.
 * is_dense is not believed: clouds that wrongly claim it exist.
 * \param[in] indices of the cloud's points to use, in any order, given twice or not;
 * null: all
 * \param[in] step the origin is a whole multiple of it along each axis; 0: of whatever
 * suits the points
 * \return the finite ones, each once; their origin is near most of them */
Points
finitePoints (const CloudView& cloud,
              unsigned threads,
              const pcl::Indices* indices = nullptr,
              double step = 0.0);

/** \brief The same without points that decide more than their place does, as the
 * engines of voxels and of the paper count points, not places: many equal points would
 * set the sizes that follow from how dense a cloud is, the zero of the frame and where
 * a cloud ends.
 *
 * Where a good share of all points have equals the first one stands for the others at
 * its place, \ref Points::copies. A place with so many that they are no readings but
 * what a sensor writes for missing ones counts as if it were NaN, \ref firstAtPlace. */
Points
distinctPoints (const CloudView& cloud,
                unsigned threads,
                const pcl::Indices* indices = nullptr,
                double step = 0.0);

} // namespace pcl_ops::internal
