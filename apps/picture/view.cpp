// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view.h"

#include <pcl/common/angles.h>
#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include <numbers/statistics.h>

namespace pcl_ops::apps {

namespace {

using Points = std::vector<Eigen::Vector3f>;

// Angles, shares and distances in this file are chosen by eye.

/** \brief Share of the points at each end of each axis that \ref boxOf leaves out. */
constexpr double outlier_share = 0.005;

/** \brief The most points to which a view is fitted; more would hardly change it. */
constexpr std::size_t max_points = 20000;

/** \brief Returns a sample of the finite points. */
Points
someFinitePoints (const XyzCloud& cloud)
{
  const std::size_t step = cloud.size() / max_points + 1;
  Points points;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (pcl::isXYZFinite (cloud[i]))
      points.push_back (cloud[i].getVector3fMap());
  return points;
}

/** \brief Returns a sample of the inliers of all planes. */
Points
somePointsOn (const std::vector<PlaneSegment>& planes, const XyzCloud& cloud)
{
  const std::size_t step = cloud.size() / max_points + 1;
  Points points;
  for (const PlaneSegment& plane : planes)
    for (std::size_t i = 0; i < plane.inliers.size(); i += step)
      points.push_back (cloud[plane.inliers[i]].getVector3fMap());
  return points;
}

/** \brief Returns a box around all points but outliers (\ref outlier_share). */
template <typename Vector>
Eigen::AlignedBox<float, Vector::SizeAtCompileTime>
boxOf (const std::vector<Vector>& points)
{
  return {quantileOfEach (points, outlier_share),
          quantileOfEach (points, 1.0 - outlier_share)};
}

/** \brief Returns the axes of an image in rows: right, down and forward.
 * \param[in] down rough direction; it is made perpendicular to \p forward */
Eigen::Matrix3f
axesOf (const Eigen::Vector3f& forward, const Eigen::Vector3f& down)
{
  const Eigen::Vector3f right = down.cross (forward).normalized();
  Eigen::Matrix3f axes;
  axes << right.transpose(), forward.cross (right).transpose(), forward.transpose();
  return axes;
}

/** \brief A cone whose tip is the eye. */
struct Cone {
  /** \brief Unit vector from the eye. */
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();
  /** \brief Angle between the axis and the surface [rad]. */
  float half_angle = 0.0f;
};

/** \brief Returns the cone around 98 % of the points whose axis is the mean direction
 * to all points. */
Cone
coneOf (const Points& points, const Eigen::Vector3f& eye)
{
  constexpr double share_inside = 0.98; // of the points
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& point : points)
    sum += (point - eye).normalized();
  Cone cone;
  cone.axis = sum.normalized();
  std::vector<float> angles;
  for (const Eigen::Vector3f& point : points) {
    const float cosine = (point - eye).normalized().dot (cone.axis);
    angles.push_back (std::acos (std::clamp (cosine, -1.0f, 1.0f)));
  }
  cone.half_angle = quantile (angles, share_inside);
  return cone;
}

/** \brief Returns the direction that is down in the image of a sensor that looks along
 * \p forward:
 * - its y axis if it looks roughly along its z axis, as a camera does; the reverse of
 * its y axis if it looks roughly against its z axis;
 * - else the direction of gravity, or, if it looks almost straight up or down, any
 *   direction perpendicular to \p forward.
 * \param[in] orientation of the sensor
 * \param[in] up unit vector against gravity */
Eigen::Vector3f
downOf (const Eigen::Quaternionf& orientation,
        const Eigen::Vector3f& forward,
        const Eigen::Vector3f& up)
{
  const float max_angle_of_camera = pcl::deg2rad (40.0f); // between forward and z
  const float min_angle_to_up = pcl::deg2rad (10.0f);
  const Eigen::Vector3f sensor_y = orientation * Eigen::Vector3f::UnitY();
  const float cosine_to_z = forward.dot (orientation * Eigen::Vector3f::UnitZ());
  if (std::abs (cosine_to_z) > std::cos (max_angle_of_camera))
    return cosine_to_z > 0.0f ? sensor_y : Eigen::Vector3f (-sensor_y);
  if (std::abs (forward.dot (up)) < std::cos (min_angle_to_up))
    return -up;
  return forward.unitOrthogonal();
}

/** \brief Returns the unit vector to an eye that sees the fronts of planes best.
 * \param[in] elevation angle of this vector above the horizontal [rad] */
Eigen::Vector3f
bestSlant (const std::vector<PlaneSegment>& planes,
           const Eigen::Vector3f& up,
           float elevation)
{
  constexpr int directions = 24; // of which one is chosen, all around the cloud
  const Eigen::Vector3f side = up.unitOrthogonal();
  Eigen::Vector3f best = up;
  // Sums over planes seen from the front: number of inliers times the cosine of the
  // angle between the normal and the direction to the eye.
  double most_seen = -1.0;
  for (int i = 0; i < directions; ++i) {
    const float azimuth = pcl::deg2rad (360.0f) * static_cast<float> (i) / directions;
    const Eigen::Vector3f level = Eigen::AngleAxisf (azimuth, up) * side;
    const Eigen::Vector3f slant =
        std::cos (elevation) * level + std::sin (elevation) * up;
    double seen = 0.0;
    for (const PlaneSegment& plane : planes)
      seen += std::max (0.0, plane.normal.dot (slant.cast<double>())) *
              static_cast<double> (plane.inliers.size());
    if (seen > most_seen) {
      most_seen = seen;
      best = slant;
    }
  }
  return best;
}

/** \brief Whether most of the points on planes are on planes that the eye sees from
 * behind. It takes a point of the cloud for the position of a plane, as the centroid
 * may be in another frame, that of the file, while cloud and eye are in the frame of
 * ShiftedCloud::cloud. */
bool
seesMostlyBacks (const XyzCloud& cloud,
                 const std::vector<PlaneSegment>& planes,
                 const Eigen::Vector3f& eye)
{
  std::size_t points = 0;
  std::size_t points_from_behind = 0;
  for (const PlaneSegment& plane : planes) {
    points += plane.inliers.size();
    if (plane.inliers.empty())
      continue;
    const Eigen::Vector3f to_eye = eye - cloud[plane.inliers.front()].getVector3fMap();
    if (plane.normal.dot (to_eye.cast<double>()) <= 0.0)
      points_from_behind += plane.inliers.size();
  }
  return 2 * points_from_behind > points;
}

/** \brief Sets a view of the cloud from outside and above. If the sensor was inside the
 * box, planes that are seen from behind are hidden. If this hides most points on
 * planes, the view is from below. If the view from below hides most of them, too, it is
 * from above and no plane is hidden.
 * \param[in] box around the points
 * \param[in] up unit vector against gravity
 * \param[in,out] view before the call, its eye is the position of the sensor */
void
lookInto (const Eigen::AlignedBox3f& box,
          const XyzCloud& cloud,
          const std::vector<PlaneSegment>& planes,
          const Eigen::Vector3f& up,
          View& view)
{
  constexpr float distance_in_diagonals = 1.5f; // of the eye from the center of the box
  const float elevation = pcl::deg2rad (40.0f);
  const float diagonal = box.diagonal().norm();
  const float distance = diagonal > 0.0f ? distance_in_diagonals * diagonal : 1.0f;
  view.hides_backs = box.contains (view.eye);
  Eigen::Vector3f slant = bestSlant (planes, up, elevation);
  const auto eye_of_slant = [&] { return box.center() + distance * slant; };
  if (view.hides_backs && seesMostlyBacks (cloud, planes, eye_of_slant()))
    slant = bestSlant (planes, up, -elevation);
  if (view.hides_backs && seesMostlyBacks (cloud, planes, eye_of_slant())) {
    slant = bestSlant (planes, up, elevation);
    view.hides_backs = false;
  }
  view.eye = eye_of_slant();
  view.axes = axesOf (-slant, -up);
}

/** \brief Zooms and shifts the image, so that the points except outliers fill it up to
 * a margin.
 * \param[in] width, height of the image [pixel]
 * \param[in,out] view whose focal length and center are set */
void
fit (const Points& points, int width, int height, View& view)
{
  constexpr float filled_share = 0.95f; // of the width or the height of the image
  constexpr float min_size = 1e-6f;     // not to divide by 0
  // The points are projected with a focal length of 1 and a principal point of zero.
  view.focal = 1.0f;
  view.center.setZero();
  std::vector<Eigen::Vector2f> projected;
  for (const Eigen::Vector3f& point : points)
    if (const Eigen::Vector3f pixel = view.project (point); pixel.z() > 0.0f)
      projected.emplace_back (pixel.head<2>());
  if (projected.empty())
    return;
  const Eigen::AlignedBox2f box = boxOf (projected);
  const Eigen::Vector2f size = Eigen::Vector2i (width, height).cast<float>();
  view.focal =
      filled_share * (size.array() / box.sizes().array().max (min_size)).minCoeff();
  view.center = size / 2.0f - view.focal * box.center();
}

} // namespace

View
chooseView (const XyzCloud& cloud,
            const std::vector<PlaneSegment>& planes,
            const Eigen::Vector3f& up,
            int width,
            int height)
{
  // The half angles of the cone that a sensor sees. If the cone of the points is
  // narrower, the cloud is too far away; if it is wider, the points lie all around the
  // sensor.
  const float min_half_angle = pcl::deg2rad (2.5f);
  const float max_half_angle = pcl::deg2rad (60.0f);
  Points points = someFinitePoints (cloud);
  View view;
  if (points.empty())
    return view;
  const Eigen::Vector3f up_axis = up.normalized();
  view.eye = cloud.sensor_origin_.head<3>();
  const Cone cone = coneOf (points, view.eye);
  if (cone.half_angle > min_half_angle && cone.half_angle < max_half_angle)
    view.axes =
        axesOf (cone.axis, downOf (cloud.sensor_orientation_, cone.axis, up_axis));
  else {
    if (!planes.empty())
      points = somePointsOn (planes, cloud);
    lookInto (boxOf (points), cloud, planes, up_axis, view);
  }
  fit (points, width, height, view);
  return view;
}

} // namespace pcl_ops::apps
