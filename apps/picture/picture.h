// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include "colors.h"
#include "view.h"
#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <cstdint>
#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief The point that each pixel of an image shows, and its depth. The arrays are
 * indexed by the column and then by the row of the image: points (column, row). */
struct Raster {
  static constexpr pcl::index_t nothing = -1;

  /** \brief Index of the point in the cloud; \ref nothing where no point is seen. */
  Eigen::Array<pcl::index_t, Eigen::Dynamic, Eigen::Dynamic> points;
  /** \brief Distance along the viewing direction [unit of the cloud]; infinite where no
   * point is seen. */
  Eigen::ArrayXXf depths;
};

/** \brief Draws points as squares, roughly as large as is needed to close the gaps
 * between them, nearer ones over farther ones. Points that are not finite are not
 * drawn.
 * \param[in] width, height of the image [pixel]
 * \param[in] is_shown whether to draw the point with an index */
Raster
drawPoints (const XyzCloud& cloud,
            const View& view,
            int width,
            int height,
            const std::function<bool (pcl::index_t point)>& is_shown);

/** \brief A cloud in the view that \ref savePicture chooses, to be drawn in any colors.
 */
class CloudPicture {
public:
  /** \param[in] labels for each point: 0 for no plane, else the index of its plane in
   * \p planes plus 1
   * \param[in] planes of the cloud; those that are seen from behind are not drawn if
   * View::hides_backs is true
   * \param[in] up direction against gravity */
  CloudPicture (const XyzCloud& cloud,
                const std::vector<std::uint32_t>& labels,
                const std::vector<PlaneSegment>& planes,
                const Eigen::Vector3f& up);

  /** \brief Calls \p visit (column, row, index of the point, brightness from 0 to 1)
   * for each pixel that shows a point. */
  template <typename Visit>
  void
  forEachPixel (Visit&& visit) const
  {
    for (int row = 0; row < raster_.points.cols(); ++row)
      for (int column = 0; column < raster_.points.rows(); ++column)
        if (const pcl::index_t point = raster_.points (column, row);
            point != Raster::nothing)
          visit (column, row, point, brightness_ (column, row));
  }

  const View&
  view () const
  {
    return view_;
  }

  /** \brief Writes a PNG of a single picture in exactly these colors, without shading.
   * \param[in] colors one for each point
   * \param[in] scale the color scale for the legend; nullptr: no legend */
  void
  save (const std::string& file,
        const std::vector<pcl::RGB>& colors,
        const ColorScale* scale = nullptr) const;

private:
  View view_;
  Raster raster_;
  /** \brief Brightness of each pixel, 0 to 1, indexed as \ref Raster. */
  Eigen::ArrayXXf brightness_;
};

/** \brief Writes a PNG with two pictures of a cloud in the view of \ref chooseView:
 * left each plane has its own color, right the color of its orientation, with a legend.
 * Points on no plane are gray.
 * \param[in] labels for each point: 0 for no plane, else the index of its plane in \p
 * planes plus 1
 * \param[in] up direction against gravity
 * \param[in] ids of the planes, which decide on their own colors; empty: 1, 2, ... */
void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids = {});

} // namespace pcl_ops::apps
