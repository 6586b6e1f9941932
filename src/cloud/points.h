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

// Names of the library that the public headers need, too, are in namespace detail.
using namespace detail;

/** \brief Positions in space [m] as a structure of arrays, in single precision. */
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

/** \brief A duplicate: a point of the cloud that another point with equal coordinates
 * represents. */
struct Copy {
  /** \brief Index of the duplicate in the input cloud. */
  pcl::index_t index;
  /** \brief Index in \ref Points of the point that represents it. */
  std::uint32_t point;
};

/** \brief The finite points that a detector works on. Their coordinates are relative to
 * \ref origin, in the local frame: so single precision suffices however far away the
 * cloud is. The axes of the local frame are those of the input cloud. */
struct Points : Coordinates {
  /** \brief Origin of the local frame, in the frame of the input cloud. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Index of each point in the input cloud; ascending, each once. Empty in the
   * usual case that the points are the whole cloud: use \ref indexOf. */
  pcl::Indices index;
  /** \brief Duplicates by ascending indices; empty unless \ref distinctPoints found
   * some.
   */
  std::vector<Copy> copies;

  pcl::index_t
  indexOf (std::size_t point) const
  {
    return index.empty() ? static_cast<pcl::index_t> (point) : index[point];
  }
};

/** \brief Indices of a stage's own items: points, voxels or samples. Indices into the
 * input cloud are pcl::Indices. */
using Indices = std::vector<std::uint32_t>;

/** \brief Returns the points with the given indices, in the order of the indices. */
Coordinates
selected (const Coordinates& points, const Indices& indices);

/** \brief Returns a pseudorandom sample of up to about \p wanted, 1 or more, of the
 * finite points, or all of them if there are fewer than \p wanted points, finite or
 * not. The sample is the same for any order of the points, and mostly the same if
 * coordinates are rounded or multiplied by a power of two. */
Coordinates
samplePoints (const Coordinates& points, std::size_t wanted);

/** \brief Returns the ascending indices of such a sample. It is the same for any order
 * of the points, but a different one if coordinates are rounded. */
Indices
sampleIndices (const Coordinates& points, std::size_t wanted);

/** \brief Returns the median, or the upper one of two middle values; 0 for no values.
 * Reorders \p values. */
double
medianOf (std::vector<float>& values);

/** \brief Drops points with a NaN or infinite coordinate, once for all stages. The flag
 * pcl::PointCloud::is_dense is ignored: some clouds set it wrongly.
 * \param[in] threads largest number of threads; 0: one for each processor
 * \param[in] indices of the points to use, in any order, repeated or not; null: all
 * \param[in] step of the origin [m]: each coordinate of Points::origin is a multiple of
 * it, rounded to single precision; 0: the function chooses the step
 * \return the finite points, in the order of their indices, each index once; their
 * origin is near most of them, but zero along axes where these are beyond 10^30: so no
 * point leaves the range of single precision */
Points
finitePoints (const CloudView& cloud,
              unsigned threads,
              const pcl::Indices* indices = nullptr,
              double step = 0.0);

/** \brief Like \ref finitePoints, but removes equal points that would dominate. The
 * engines of voxels and of the paper count points, not distinct places: many equal
 * points would determine the sizes derived from point density, the origin of the local
 * frame and the bounds of the cloud.
 *
 * If a large share of all points has duplicates, the first point at each place
 * represents the others (\ref Points::copies). If so many points are at one place that
 * it must be a sensor's code for missing readings, they are dropped like NaN (\ref
 * firstAtPlace). */
Points
distinctPoints (const CloudView& cloud,
                unsigned threads,
                const pcl::Indices* indices = nullptr,
                double step = 0.0);

} // namespace pcl_ops::internal
