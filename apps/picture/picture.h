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

/** \brief The point that each pixel of an image shows, and its depth. Columns of the
 * image are rows of these arrays: points (column, row). */
struct Raster {
  static constexpr pcl::index_t nothing = -1;

  /** \brief Index of the point in the cloud; \ref nothing where no point is seen. */
  Eigen::Array<pcl::index_t, Eigen::Dynamic, Eigen::Dynamic> points;
  /** \brief Along the viewing direction; infinite where no point is seen. */
  Eigen::ArrayXXf depths;
};

/** \brief Draws points as squares, roughly as large as is needed to close the gaps
 * between them, the nearest in front. Non-finite points are not drawn.
 * \param[in] width, height of the image [pixel] */
Raster
drawPoints (const XyzCloud& cloud,
            const View& view,
            int width,
            int height,
            const std::function<bool (pcl::index_t point)>& is_shown);

/** \brief A cloud as \ref savePicture shows it, to be drawn in any colors. */
class CloudPicture {
public:
  /** \param[in] labels per point: 0 for no plane, else its index in \p planes plus 1
   * \param[in] planes their points are left out where they are seen from behind, if
   * View::hides_backs says so
   * \param[in] up direction against gravity */
  CloudPicture (const XyzCloud& cloud,
                const std::vector<std::uint32_t>& labels,
                const std::vector<PlaneSegment>& planes,
                const Eigen::Vector3f& up);

  /** \brief Visits the pixels that show a point.
   * \param[in] visit (column, row, point, brightness) */
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
   * \param[in] colors per point
   * \param[in] scale what the colors mean; nullptr: no legend */
  void
  save (const std::string& file,
        const std::vector<pcl::RGB>& colors,
        const ColorScale* scale = nullptr) const;

private:
  View view_;
  Raster raster_;
  /** \brief Of each pixel, 0 to 1, by column and row. */
  Eigen::ArrayXXf brightness_;
};

/** \brief Writes a PNG with two pictures of a cloud (\ref chooseView): left each plane
 * in its own color, right in that of its orientation, with a legend; gray for no plane.
 * \param[in] labels per point: 0 for no plane, else its index in \p planes plus 1
 * \param[in] up direction against gravity
 * \param[in] ids of the planes, which decide on their colors; empty: 1, 2, ... */
void
savePicture (const std::string& file,
             const XyzCloud& cloud,
             const std::vector<std::uint32_t>& labels,
             const std::vector<PlaneSegment>& planes,
             const Eigen::Vector3f& up,
             const std::vector<std::uint32_t>& ids = {});

} // namespace pcl_ops::apps
