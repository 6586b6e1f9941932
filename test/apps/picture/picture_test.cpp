// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <picture/colors.h>
#include <picture/image.h>
#include <picture/picture.h>
#include <picture/view.h>
#include <support/cloud_values.h>

#include <fstream>
#include <numeric>
#include <set>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

constexpr int image_width = 200;  // [pixel]
constexpr int image_height = 150; // [pixel]
const Eigen::Vector3f z_axis = Eigen::Vector3f::UnitZ();

void
add (XyzCloud& cloud, const Eigen::Vector3f& point)
{
  cloud.emplace_back (point.x(), point.y(), point.z());
}

/** \brief Adds a square of 2 m x 2 m of 21 x 21 points to a cloud and returns its
 * plane.
 * \param[in] center of the square [m]
 * \param[in] u,v unit vectors along its edges; the normal is u x v */
PlaneSegment
addSquare (XyzCloud& cloud,
           const Eigen::Vector3f& center,
           const Eigen::Vector3f& u,
           const Eigen::Vector3f& v)
{
  PlaneSegment plane;
  plane.normal = u.cross (v).cast<double>();
  plane.centroid = center.cast<double>();
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j) {
      plane.inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
      add (cloud,
           center + 0.1f * static_cast<float> (i) * u +
               0.1f * static_cast<float> (j) * v);
    }
  return plane;
}

View
viewOf (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes = {})
{
  return chooseView (cloud, planes, z_axis, image_width, image_height);
}

} // namespace

TEST (View, HasRightAndDownOfTheSensorOrDownAlongGravity)
{
  constexpr float pi = 3.1415927f;
  const Eigen::Vector3f x_axis (1, 0, 0), y_axis (0, 1, 0);
  const struct {
    const char* sensor;
    float turned; // about its z axis [rad]
    Eigen::Vector3f eye, center, u, v, right, down;
  } rows[] = {
      {"camera", 0.0f, {0, 0, 0}, {0, 0, 3}, x_axis, y_axis, x_axis, y_axis},
      {"upside down", pi, {0, 0, 0}, {0, 0, 3}, x_axis, y_axis, -x_axis, -y_axis},
      {"looks sideways", 0.0f, {0, 0, 1}, {5, 0, 1}, y_axis, z_axis, -y_axis, -z_axis}};
  for (const auto& row : rows) {
    SCOPED_TRACE (row.sensor);
    XyzCloud wall;
    addSquare (wall, row.center, row.u, row.v);
    wall.sensor_origin_.head<3>() = row.eye;
    wall.sensor_orientation_ = Eigen::AngleAxisf (row.turned, z_axis);
    const View view = viewOf (wall);
    const Eigen::Vector3f middle = view.project (row.center);
    EXPECT_GT (view.project (row.center + row.right).x(), middle.x());
    EXPECT_GT (view.project (row.center + row.down).y(), middle.y());
  }
}

TEST (View, LooksFromAboveIntoARoomAroundTheSensor)
{
  XyzCloud room;
  const std::vector<PlaneSegment> planes = {
      addSquare (room, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}),
      addSquare (room, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
      addSquare (room, {1, 0, 0}, {0, 0, 1}, {0, 1, 0})};
  const View view = viewOf (room, planes);
  EXPECT_TRUE (view.hides_backs);
  EXPECT_GT (view.eye.z(), 1.0f);
  EXPECT_GT (view.project ({0, 0, -1}).y(), view.project ({0, 0, 1}).y());
}

TEST (View, IsTheSameForPlanesInMapCoordinates)
{
  XyzCloud hall;
  std::vector<PlaneSegment> planes = {
      addSquare (hall, {-1, 0, 1}, {0, 1, 0}, {1, 0, 0}),
      addSquare (hall, {1, 0, 1}, {0, 1, 0}, {1, 0, 0}),
      addSquare (hall, {0, 0, -1}, {1, 0, 0}, {0, 1, 0})};
  const View expected = viewOf (hall, planes);
  for (const double height : {-300.0, 300.0}) {
    for (PlaneSegment& plane : planes)
      plane.centroid = {448000.0, 5411000.0, height};
    EXPECT_EQ (viewOf (hall, planes).eye, expected.eye) << height;
  }
}

TEST (View, LooksFromBelowAtCeilingsAroundTheSensor)
{
  XyzCloud hall;
  const std::vector<PlaneSegment> planes = {
      addSquare (hall, {-1, 0, 1}, {0, 1, 0}, {1, 0, 0}),
      addSquare (hall, {1, 0, 1}, {0, 1, 0}, {1, 0, 0}),
      addSquare (hall, {0, 0, -1}, {1, 0, 0}, {0, 1, 0})};
  const View view = viewOf (hall, planes);
  EXPECT_TRUE (view.hides_backs);
  EXPECT_LT (view.eye.z(), -1.0f);
}

TEST (View, HidesNoBacksWhereItWouldHideMostPlanesFromAboveAndFromBelow)
{
  XyzCloud walls;
  std::vector<PlaneSegment> planes;
  for (const float degrees : {0.0f, 0.0f, 110.0f, -110.0f, 180.0f}) {
    const Eigen::AngleAxisf turn (degrees * 3.1415927f / 180.0f, z_axis);
    planes.push_back (addSquare (
        walls, {0, 0, 0}, turn * Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitZ()));
  }
  EXPECT_FALSE (viewOf (walls, planes).hides_backs);
  planes.resize (2);
  EXPECT_TRUE (viewOf (walls, planes).hides_backs);
}

TEST (View, FillsTheImage)
{
  XyzCloud wall;
  addSquare (wall, {0, 0, 3}, {1, 0, 0}, {0, 1, 0});
  const View view = viewOf (wall);
  const Eigen::Vector3f low = view.project ({-1, -1, 3}),
                        high = view.project ({1, 1, 3});
  EXPECT_GT (low.x(), 0.0f);
  EXPECT_GT (low.y(), 0.0f);
  EXPECT_LT (high.x(), image_width);
  EXPECT_LT (high.y(), image_height);
  EXPECT_GT (high.y() - low.y(), 0.9f * image_height);
}

TEST (View, ExistsForACloudOfNothingOrOfOnePoint)
{
  XyzCloud cloud;
  viewOf (cloud);
  add (cloud, {1, 2, 3});
  const Eigen::Vector3f pixel = viewOf (cloud).project ({1, 2, 3});
  EXPECT_TRUE (pixel.allFinite()) << pixel.transpose();
}

TEST (Raster, HasTheNearestOfThePointsThatAreShownWithoutGaps)
{
  XyzCloud cloud;
  addSquare (cloud, {0, 0, 4}, {1, 0, 0}, {0, 1, 0});
  const auto first_of_near = static_cast<pcl::index_t> (cloud.size());
  addSquare (cloud, {0, 0, 3}, {1, 0, 0}, {0, 1, 0});
  const auto draw = [&] (bool is_shown) {
    return drawPoints (
        cloud, viewOf (cloud), image_width, image_height, [&] (pcl::index_t) {
          return is_shown;
        });
  };
  const Raster raster = draw (true);
  for (int row = image_height / 3; row < 2 * image_height / 3; ++row)
    for (int column = image_width / 3; column < 2 * image_width / 3; ++column)
      ASSERT_GE (raster.points (column, row), first_of_near)
          << "at " << column << ", " << row;
  EXPECT_TRUE ((draw (false).points == Raster::nothing).all());
}

TEST (Colors, OfLabelsUpTo100AndOfNoPlaneAllDiffer)
{
  std::set<std::uint32_t> seen;
  for (std::uint32_t label = 0; label <= 100; ++label)
    seen.insert (colorOfLabel (label).rgba);
  EXPECT_EQ (seen.size(), 101u);
  EXPECT_EQ (colorOfLabel (0).r, colorOfLabel (0).g);
  EXPECT_NO_THROW (colorOfLabel (1000000));
}

TEST (ColorScale, EndsAtRoundNumbersBeyondMostValues)
{
  std::vector<float> values = {0.0f, -1.0f, NAN, INFINITY};
  values.insert (values.end(), 500, 0.003f);
  values.insert (values.end(), 500, 0.07f);
  values.insert (values.end(), 9, 1000.0f);
  values.insert (values.end(), 9, 1e-6f);
  const ColorScale scale (values);
  EXPECT_NEAR (scale.smallest, 0.002, 1e-9);
  EXPECT_NEAR (scale.largest, 0.1, 1e-9);
}

TEST (ColorScale, GoesFromTheSmallestToTheLargestValueByTheLogarithm)
{
  std::vector<float> values (100, 0.01f);
  values.resize (200, 1.0f);
  const ColorScale scale (values);
  // Whether a value has the color at this share of the scale.
  const auto isColorAt = [&] (float value, float share) {
    return scale (value).rgba == ColorScale::at (share).rgba;
  };
  EXPECT_TRUE (isColorAt (0.0f, 0.0f));
  EXPECT_TRUE (isColorAt (0.0099f, 0.0f));
  EXPECT_TRUE (isColorAt (0.1f, 0.5f));
  EXPECT_TRUE (isColorAt (1.0f, 1.0f));
  EXPECT_TRUE (isColorAt (INFINITY, 1.0f));
  EXPECT_EQ (scale (NAN).rgba, colorOfLabel (0).rgba);
}

TEST (ColorScale, HasColorsWhereAllValuesAreEqualOrThereAreNone)
{
  EXPECT_NE (ColorScale ({0.2f, 0.2f}) (0.2f).rgba, colorOfLabel (0).rgba);
  EXPECT_NE (ColorScale ({}) (0.0f).rgba, colorOfLabel (0).rgba);
}

TEST (CloudPicture, ShowsAPointInEachPixelOfItsSurface)
{
  XyzCloud cloud;
  const PlaneSegment wall = addSquare (cloud, {0, 0, 3}, {1, 0, 0}, {0, -1, 0});
  add (cloud, {NAN, 0, 3});
  const std::vector<std::uint32_t> labels (cloud.size(), 1);
  const CloudPicture picture (cloud, labels, {wall}, z_axis);
  std::set<pcl::index_t> shown;
  int pixels = 0;
  picture.forEachPixel ([&] (int column, int row, pcl::index_t point, float light) {
    ++pixels;
    shown.insert (point);
    EXPECT_LT (column, Image::half_width);
    EXPECT_LT (row, Image::height);
    EXPECT_LE (light, 1.0f);
  });
  EXPECT_GT (pixels, 10000);
  EXPECT_EQ (shown.size(), wall.inliers.size());
}

TEST (CloudPicture, IsSavedAsOnePictureWithOrWithoutAScale)
{
  XyzCloud cloud;
  const PlaneSegment wall = addSquare (cloud, {0, 0, 3}, {1, 0, 0}, {0, -1, 0});
  const CloudPicture picture (
      cloud, std::vector<std::uint32_t> (cloud.size(), 1), {wall}, z_axis);
  const TemporaryFolder folder;
  const std::vector<pcl::RGB> colors (cloud.size(), pcl::RGB (10, 20, 30));
  const ColorScale scale ({0.002f, 0.1f});
  picture.save (folder / "labels.png", colors);
  picture.save (folder / "values.png", colors, &scale);
  for (const char* file : {"labels.png", "values.png"}) {
    const std::string png = contentOf (folder / file);
    // The low bytes of the width, which begins at byte 16: behind the signature and the
    // head of the first chunk.
    EXPECT_EQ (static_cast<unsigned char> (png.at (18)), Image::half_width / 256);
    EXPECT_EQ (static_cast<unsigned char> (png.at (19)), Image::half_width % 256);
  }
  EXPECT_NE (contentOf (folder / "labels.png"), contentOf (folder / "values.png"));
}

TEST (MapPicture, ShowsTheUpperPlaneInBothColorsAndWhatIsInItsHole)
{
  const auto square = [] (double from, double to) {
    return std::vector<Eigen::Vector3d> (
        {{from, from, 0}, {to, from, 0}, {to, to, 0}, {from, to, 0}});
  };
  const MapShape roof{
      1, Orientation::Other, 5.0, {square (0.0, 8.0), square (2.0, 6.0)}};
  const MapShape ground{2, Orientation::Horizontal, 0.0, {square (0.0, 8.0)}};
  const Image image = mapPicture ({roof, ground});
  const auto pixelsOf = [&] (const pcl::RGB& color) {
    int pixels = 0;
    for (std::size_t i = 0; i < image.bytes.size(); i += 3)
      pixels += image.bytes[i] == color.r && image.bytes[i + 1] == color.g &&
                image.bytes[i + 2] == color.b;
    return pixels;
  };
  const int of_ground = pixelsOf (colorOfLabel (2));
  EXPECT_GT (of_ground, 10000);
  EXPECT_NEAR (pixelsOf (colorOfLabel (1)), 3 * of_ground, 0.02 * of_ground);
  // The legend has boxes in these colors, of up to 400 pixels each.
  EXPECT_NEAR (pixelsOf (colorOf (Orientation::Horizontal)), of_ground, 400);
  EXPECT_NEAR (
      pixelsOf (colorOf (Orientation::Other)), 3 * of_ground, 0.02 * of_ground);
}

namespace {

/** \brief The number in a line of /proc/self/status [byte]; the line says it in kB. */
std::size_t
statusBytes (const std::string& name)
{
  std::ifstream status ("/proc/self/status");
  for (std::string line; std::getline (status, line);)
    if (line.rfind (name + ":", 0) == 0)
      return 1024 * std::stoul (line.substr (name.size() + 1));
  return 0;
}

} // namespace

TEST (LabelledCloud, IsSavedWithoutMemoryForACopy)
{
#ifdef PCL_OPS_SANITIZED
  GTEST_SKIP() << "sanitizers keep what is freed";
#endif
  constexpr std::size_t size = 4000000;
  const TemporaryFolder folder;
  FileCloud cloud;
  cloud.points.width = size;
  cloud.points.height = 1;
  for (const char* name : {"x", "y", "z"})
    addField (name, pcl::PCLPointField::UINT8, cloud.points);
  cloud.points.data.resize (cloud.points.point_step * size);
  std::vector<std::uint32_t> labels (size);
  std::iota (labels.begin(), labels.end(), 0U);
  const std::vector<float> distances (labels.begin(), labels.end());
  for (const char* name : {"a.ply", "a.pcd"}) {
    std::ofstream ("/proc/self/clear_refs") << "5"; // sets the peak (VmHWM) to VmRSS
    const std::size_t before = statusBytes ("VmRSS");
    saveLabelledCloud (folder / name, cloud, labels, distances, false);
    EXPECT_LT (statusBytes ("VmHWM") - before, 2 * size) << name;
  }
  const FileCloud saved = loadCloud (folder / "a.pcd");
  const std::vector<double> numbers (labels.begin(), labels.end());
  EXPECT_TRUE (valuesOf (saved, "label") == numbers);
  EXPECT_TRUE (valuesOf (saved, "distance") == numbers);
}
