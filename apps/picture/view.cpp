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

/** \brief Share of points at either end of an axis that the fit of a view ignores. */
constexpr double outliers = 0.005;

/** \brief About the most points a view is fitted to; more would not change it. */
constexpr std::size_t enough = 20000;

Points
someFinitePoints (const XyzCloud& cloud)
{
  const std::size_t step = cloud.size() / enough + 1;
  Points points;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (pcl::isXYZFinite (cloud[i]))
      points.push_back (cloud[i].getVector3fMap());
  return points;
}

Points
somePointsOn (const std::vector<PlaneSegment>& planes, const XyzCloud& cloud)
{
  const std::size_t step = cloud.size() / enough + 1;
  Points points;
  for (const PlaneSegment& plane : planes)
    for (std::size_t i = 0; i < plane.inliers.size(); i += step)
      points.push_back (cloud[plane.inliers[i]].getVector3fMap());
  return points;
}

template <typename Vector>
Eigen::AlignedBox<float, Vector::SizeAtCompileTime>
boxOf (const std::vector<Vector>& points)
{
  return {quantileOfEach (points, outliers), quantileOfEach (points, 1.0 - outliers)};
}

/** \brief The axes of an image in rows: right, down and forward.
 * \param[in] down rough direction; it is made perpendicular to \p forward */
Eigen::Matrix3f
axesOf (const Eigen::Vector3f& forward, const Eigen::Vector3f& down)
{
  const Eigen::Vector3f right = down.cross (forward).normalized();
  Eigen::Matrix3f axes;
  axes << right.transpose(), forward.cross (right).transpose(), forward.transpose();
  return axes;
}

/** \brief Mean direction to the points, and half the angle that holds nearly all. */
struct Cone {
  Eigen::Vector3f axis = Eigen::Vector3f::UnitZ();
  float half_angle = 0.0f;
};

Cone
coneOf (const Points& points, const Eigen::Vector3f& eye)
{
  constexpr double nearly_all = 0.98;
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
  cone.half_angle = quantile (angles, nearly_all);
  return cone;
}

/** \brief Direction that is down in the image of a sensor looking along \p forward: its
 * y axis if it looks roughly along its z axis, as a camera does, reversed for -z; else
 * along gravity, or any perpendicular direction if it looks almost straight up or down.
 */
Eigen::Vector3f
downOf (const Eigen::Quaternionf& orientation,
        const Eigen::Vector3f& forward,
        const Eigen::Vector3f& up)
{
  const float camera_like = pcl::deg2rad (40.0f);
  const Eigen::Vector3f sensor_y = orientation * Eigen::Vector3f::UnitY();
  const float along_z = forward.dot (orientation * Eigen::Vector3f::UnitZ());
  if (std::abs (along_z) > std::cos (camera_like))
    return along_z > 0.0f ? sensor_y : Eigen::Vector3f (-sensor_y);
  const float almost_parallel = pcl::deg2rad (10.0f);
  if (std::abs (forward.dot (up)) < std::cos (almost_parallel))
    return -up;
  return forward.unitOrthogonal();
}

/** \param[in] elevation of the eye above the horizontal [rad]
 * \return unit vector to the eye that sees the planes' fronts best */
Eigen::Vector3f
bestSlant (const std::vector<PlaneSegment>& planes,
           const Eigen::Vector3f& up,
           float elevation)
{
  constexpr int directions = 24;
  const Eigen::Vector3f side = up.unitOrthogonal();
  Eigen::Vector3f best = up;
  double best_seen = -1.0;
  for (int i = 0; i < directions; ++i) {
    const float azimuth = pcl::deg2rad (360.0f) * static_cast<float> (i) / directions;
    const Eigen::Vector3f level = Eigen::AngleAxisf (azimuth, up) * side;
    const Eigen::Vector3f slant =
        std::cos (elevation) * level + std::sin (elevation) * up;
    double seen = 0.0;
    for (const PlaneSegment& plane : planes)
      seen += std::max (0.0, plane.normal.dot (slant.cast<double>())) *
              static_cast<double> (plane.inliers.size());
    if (seen > best_seen) {
      best_seen = seen;
      best = slant;
    }
  }
  return best;
}

/** \brief Whether most of the points on planes are on planes that the eye sees from
 * behind. */
bool
hidesMost (const std::vector<PlaneSegment>& planes, const Eigen::Vector3f& eye)
{
  std::size_t all = 0;
  std::size_t hidden = 0;
  for (const PlaneSegment& plane : planes) {
    all += plane.inliers.size();
    if (plane.normal.dot (eye.cast<double>() - plane.centroid) <= 0.0)
      hidden += plane.inliers.size();
  }
  return 2 * hidden > all;
}

/** \brief Sets a view into the cloud from outside and above. If the sensor was inside
 * the box, planes seen from behind are left out. If that hides most points on planes,
 * the view is from below. If that hides most, too, it is from above with all planes. */
void
lookInto (const Eigen::AlignedBox3f& box,
          const std::vector<PlaneSegment>& planes,
          const Eigen::Vector3f& up,
          View& view)
{
  constexpr float distance_in_diagonals = 1.5f;
  const float elevation = pcl::deg2rad (40.0f);
  const float diagonal = box.diagonal().norm();
  const float distance = diagonal > 0.0f ? distance_in_diagonals * diagonal : 1.0f;
  view.hides_backs = box.contains (view.eye);
  Eigen::Vector3f slant = bestSlant (planes, up, elevation);
  const auto eye_at = [&] { return box.center() + distance * slant; };
  if (view.hides_backs && hidesMost (planes, eye_at()))
    slant = bestSlant (planes, up, -elevation);
  if (view.hides_backs && hidesMost (planes, eye_at())) {
    slant = bestSlant (planes, up, elevation);
    view.hides_backs = false;
  }
  view.eye = eye_at();
  view.axes = axesOf (-slant, -up);
}

/** \brief Zooms and shifts the image so that the points fill it but for a margin. */
void
fit (const Points& points, int width, int height, View& view)
{
  constexpr float filled = 0.95f;
  view.focal = 1.0f;
  view.center.setZero();
  std::vector<Eigen::Vector2f> image;
  for (const Eigen::Vector3f& point : points)
    if (const Eigen::Vector3f pixel = view.project (point); pixel.z() > 0.0f)
      image.emplace_back (pixel.head<2>());
  if (image.empty())
    return;
  const Eigen::AlignedBox2f box = boxOf (image);
  const Eigen::Vector2f size = Eigen::Vector2i (width, height).cast<float>();
  constexpr float smallest = 1e-6f;
  view.focal = filled * (size.array() / box.sizes().array().max (smallest)).minCoeff();
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
  const float narrowest = pcl::deg2rad (2.5f);
  const float widest = pcl::deg2rad (60.0f);
  Points points = someFinitePoints (cloud);
  View view;
  if (points.empty())
    return view;
  const Eigen::Vector3f up_axis = up.normalized();
  view.eye = cloud.sensor_origin_.head<3>();
  const Cone cone = coneOf (points, view.eye);
  if (cone.half_angle > narrowest && cone.half_angle < widest)
    view.axes =
        axesOf (cone.axis, downOf (cloud.sensor_orientation_, cone.axis, up_axis));
  else {
    if (!planes.empty())
      points = somePointsOn (planes, cloud);
    lookInto (boxOf (points), planes, up_axis, view);
  }
  fit (points, width, height, view);
  return view;
}

} // namespace pcl_ops::apps
