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
#include <functional>
#include <numeric>
#include <set>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

constexpr int image_width = 200;  // [pixel]
constexpr int image_height = 150; // [pixel]
const Eigen::Vector3f x_axis = Eigen::Vector3f::UnitX(),
                      y_axis = Eigen::Vector3f::UnitY(),
                      z_axis = Eigen::Vector3f::UnitZ();
constexpr float pi = 3.1415927f;

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
  constexpr float spacing = 0.1f; // [m]
  for (int i = -10; i <= 10; ++i)
    for (int j = -10; j <= 10; ++j) {
      plane.inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
      add (cloud,
           center + spacing * static_cast<float> (i) * u +
               spacing * static_cast<float> (j) * v);
    }
  return plane;
}

/** \brief The view of a cloud that is chosen for the image; z is up. */
View
viewOf (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes = {})
{
  return chooseView (cloud, planes, z_axis, image_width, image_height);
}

/** \brief Adds two ceilings side by side, 1 m above the sensor, and a floor 1 m below
 * it; their normals point to the sensor, which is at the origin. */
std::vector<PlaneSegment>
addTwoCeilingsAndFloor (XyzCloud& cloud)
{
  return {addSquare (cloud, {-1, 0, 1}, y_axis, x_axis),
          addSquare (cloud, {1, 0, 1}, y_axis, x_axis),
          addSquare (cloud, {0, 0, -1}, x_axis, y_axis)};
}

} // namespace

TEST (View, HasTheImageAxesOfACameraAndGravityDownForOtherSensors)
{
  // The view of a wall: right and down in the image are these directions. A camera is a
  // sensor that looks along its z axis.
  const struct {
    const char* sensor;
    float turn;                   // of the sensor about its z axis [rad]
    Eigen::Vector3f eye;          // position of the sensor [m]
    Eigen::Vector3f center, u, v; // of the wall, as for addSquare
    Eigen::Vector3f right, down;
  } rows[] = {
      {"camera", 0.0f, {0, 0, 0}, {0, 0, 3}, x_axis, y_axis, x_axis, y_axis},
      {"upside down", pi, {0, 0, 0}, {0, 0, 3}, x_axis, y_axis, -x_axis, -y_axis},
      {"looks sideways", 0.0f, {0, 0, 1}, {5, 0, 1}, y_axis, z_axis, -y_axis, -z_axis}};
  for (const auto& row : rows) {
    SCOPED_TRACE (row.sensor);
    XyzCloud wall;
    addSquare (wall, row.center, row.u, row.v);
    wall.sensor_origin_.head<3>() = row.eye;
    wall.sensor_orientation_ = Eigen::AngleAxisf (row.turn, z_axis);
    const View view = viewOf (wall);
    // Column, row and depth.
    const Eigen::Vector3f pixel_of_center = view.project (row.center);
    EXPECT_GT (view.project (row.center + row.right).x(), pixel_of_center.x());
    EXPECT_GT (view.project (row.center + row.down).y(), pixel_of_center.y());
  }
}

TEST (View, LooksFromAboveIntoARoomAroundTheSensor)
{
  XyzCloud room;
  const std::vector<PlaneSegment> planes = {
      addSquare (room, {0, 0, -1}, x_axis, y_axis), // floor, seen from above
      addSquare (room, {-1, 0, 0}, y_axis, z_axis), // walls, seen from within
      addSquare (room, {1, 0, 0}, z_axis, y_axis)};
  const View view = viewOf (room, planes);
  EXPECT_TRUE (view.hides_backs);
  EXPECT_GT (view.eye.z(), 1.0f);
  EXPECT_GT (view.project ({0, 0, -1}).y(), view.project ({0, 0, 1}).y());
}

TEST (View, IsTheSameForPlanesInMapCoordinates)
{
  // The cloud keeps coordinates near zero, as it has a frame of its own.
  XyzCloud hall;
  std::vector<PlaneSegment> planes = addTwoCeilingsAndFloor (hall);
  const View expected = viewOf (hall, planes);
  for (const double height : {-300.0, 300.0}) {
    for (PlaneSegment& plane : planes)
      plane.centroid = {448000.0, 5411000.0, height};
    EXPECT_EQ (viewOf (hall, planes).eye, expected.eye) << height;
  }
}

TEST (View, LooksFromBelowWhereMostPlanesAreCeilings)
{
  XyzCloud hall;
  const std::vector<PlaneSegment> planes = addTwoCeilingsAndFloor (hall);
  const View view = viewOf (hall, planes);
  EXPECT_TRUE (view.hides_backs);
  EXPECT_LT (view.eye.z(), -1.0f);
}

TEST (View, HidesNoBacksIfItWouldHideMostPlanes)
{
  // Vertical walls, of which any view sees the backs of many; of the first two, which
  // have the same normal, a view sees both fronts.
  XyzCloud walls;
  std::vector<PlaneSegment> planes;
  for (const float degrees : {0.0f, 0.0f, 110.0f, -110.0f, 180.0f}) {
    const Eigen::AngleAxisf turn (degrees * pi / 180.0f, z_axis);
    planes.push_back (addSquare (walls, {0, 0, 0}, turn * y_axis, z_axis));
  }
  EXPECT_FALSE (viewOf (walls, planes).hides_backs);
  constexpr std::size_t planes_with_one_normal = 2;
  planes.resize (planes_with_one_normal);
  EXPECT_TRUE (viewOf (walls, planes).hides_backs);
}

TEST (View, FillsTheImage)
{
  XyzCloud wall;
  addSquare (wall, {0, 0, 3}, x_axis, y_axis);
  const View view = viewOf (wall);
  const Eigen::Vector3f upper_left = view.project ({-1, -1, 3}),
                        lower_right = view.project ({1, 1, 3});
  EXPECT_GT (upper_left.x(), 0.0f);
  EXPECT_GT (upper_left.y(), 0.0f);
  EXPECT_LT (lower_right.x(), image_width);
  EXPECT_LT (lower_right.y(), image_height);
  EXPECT_GT (lower_right.y() - upper_left.y(), 0.9f * image_height);
}

TEST (View, ExistsForACloudOfNoPointOrOfOnePoint)
{
  XyzCloud cloud;
  EXPECT_TRUE (viewOf (cloud).eye.allFinite());
  add (cloud, {1, 2, 3});
  const Eigen::Vector3f pixel = viewOf (cloud).project ({1, 2, 3});
  EXPECT_TRUE (pixel.allFinite()) << pixel.transpose();
}

TEST (Raster, HasThePointsOfTheNearestSurfaceWithoutGapsUnlessTheyAreNotShown)
{
  XyzCloud cloud;
  addSquare (cloud, {0, 0, 4}, x_axis, y_axis);
  const auto first_of_near = static_cast<pcl::index_t> (cloud.size());
  addSquare (cloud, {0, 0, 3}, x_axis, y_axis);
  const auto rasterWith =
      [&cloud] (const std::function<bool (pcl::index_t)>& is_shown) {
        return drawPoints (cloud, viewOf (cloud), image_width, image_height, is_shown);
      };
  const Raster raster = rasterWith ([] (pcl::index_t) { return true; });
  // The middle third of the image along both axes.
  for (int row = image_height / 3; row < 2 * image_height / 3; ++row)
    for (int column = image_width / 3; column < 2 * image_width / 3; ++column)
      ASSERT_GE (raster.points (column, row), first_of_near)
          << "at " << column << ", " << row;
  const Raster empty = rasterWith ([] (pcl::index_t) { return false; });
  EXPECT_TRUE ((empty.points == Raster::nothing).all());
}

TEST (Colors, OfLabelsUpTo100AndOfNoPlaneAllDiffer)
{
  std::set<std::uint32_t> seen;
  for (std::uint32_t label = 0; label <= 100; ++label)
    seen.insert (colorOfLabel (label).rgba);
  EXPECT_EQ (seen.size(), 101u);
  EXPECT_EQ (colorOfLabel (0).r, colorOfLabel (0).g) << "gray";
  EXPECT_NO_THROW (colorOfLabel (1000000));
}

TEST (ColorScale, EndsAtRoundNumbersBeyondAllButAFewValues)
{
  std::vector<float> values = {0.0f, -1.0f, NAN, INFINITY}; // are ignored
  values.insert (values.end(), 500, 0.003f);
  values.insert (values.end(), 500, 0.07f);
  constexpr std::size_t less_than_a_hundredth = 9;
  values.insert (values.end(), less_than_a_hundredth, 1000.0f);
  values.insert (values.end(), less_than_a_hundredth, 1e-6f);
  const ColorScale scale (values);
  EXPECT_NEAR (scale.smallest, 0.002, 1e-9);
  EXPECT_NEAR (scale.largest, 0.1, 1e-9);
}

TEST (ColorScale, IsLogarithmicFromTheSmallestToTheLargestValue)
{
  std::vector<float> values (100, 0.01f);
  values.resize (200, 1.0f);
  const ColorScale scale (values);
  // Whether a value has the color at a share of the scale: 0 at the smallest value, 1
  // at the largest.
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

TEST (CloudPicture, ShowsEachPointOfASurfaceInSomePixels)
{
  XyzCloud cloud;
  const PlaneSegment wall = addSquare (cloud, {0, 0, 3}, x_axis, -y_axis);
  add (cloud, {NAN, 0, 3});
  constexpr std::uint32_t label_of_wall = 1;
  const std::vector<std::uint32_t> labels (cloud.size(), label_of_wall);
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

TEST (CloudPicture, IsSavedAloneAsHalfAPictureWithOrWithoutAScale)
{
  XyzCloud cloud;
  const PlaneSegment wall = addSquare (cloud, {0, 0, 3}, x_axis, -y_axis);
  constexpr std::uint32_t label_of_wall = 1;
  const std::vector<std::uint32_t> labels (cloud.size(), label_of_wall);
  const CloudPicture picture (cloud, labels, {wall}, z_axis);
  const TemporaryFolder folder;
  const std::vector<pcl::RGB> colors (cloud.size(), pcl::RGB (10, 20, 30));
  const ColorScale scale ({0.002f, 0.1f});
  picture.save (folder / "labels.png", colors);
  picture.save (folder / "values.png", colors, &scale);
  for (const char* file : {"labels.png", "values.png"}) {
    const std::string png = contentOf (folder / file);
    // The width has 4 bytes, the high byte first, behind the signature and the head of
    // the first chunk.
    constexpr std::size_t offset_of_width = 16;
    EXPECT_EQ (static_cast<unsigned char> (png.at (offset_of_width + 2)),
               Image::half_width / 256);
    EXPECT_EQ (static_cast<unsigned char> (png.at (offset_of_width + 3)),
               Image::half_width % 256);
  }
  EXPECT_NE (contentOf (folder / "labels.png"), contentOf (folder / "values.png"));
}

TEST (MapPicture, ShowsTheUpperPlaneInBothHalvesAndTheLowerPlaneInItsHole)
{
  // Corners of the square with x and y from one coordinate to another [m].
  const auto square = [] (double from, double to) {
    return std::vector<Eigen::Vector3d> (
        {{from, from, 0}, {to, from, 0}, {to, to, 0}, {from, to, 0}});
  };
  constexpr std::uint32_t id_of_roof = 1, id_of_ground = 2;
  // The roof is 5 m above the ground. Its hole has a quarter of the area.
  const MapShape roof{
      id_of_roof, Orientation::Other, 5.0, {square (0.0, 8.0), square (2.0, 6.0)}};
  const MapShape ground{
      id_of_ground, Orientation::Horizontal, 0.0, {square (0.0, 8.0)}};
  const Image image = mapPicture ({roof, ground});
  const auto pixelsWith = [&image] (const pcl::RGB& color) {
    int pixels = 0;
    for (std::size_t i = 0; i < image.bytes.size(); i += 3)
      pixels += image.bytes[i] == color.r && image.bytes[i + 1] == color.g &&
                image.bytes[i + 2] == color.b;
    return pixels;
  };
  const int of_ground = pixelsWith (colorOfLabel (id_of_ground));
  EXPECT_GT (of_ground, 10000);
  EXPECT_NEAR (pixelsWith (colorOfLabel (id_of_roof)), 3 * of_ground, 0.02 * of_ground);
  // The legend has boxes in the colors of orientations, of up to 400 pixels each.
  EXPECT_NEAR (pixelsWith (colorOf (Orientation::Horizontal)), of_ground, 400);
  EXPECT_NEAR (
      pixelsWith (colorOf (Orientation::Other)), 3 * of_ground, 0.02 * of_ground);
}

TEST (Map, LeavesOutPlanesThatAreTooFarAway)
{
  const MapShape ground{
      1, Orientation::Horizontal, 0.0, {{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}}}};
  constexpr double far = 1.7e308; // twice this is infinite
  const MapShape damaged{
      2, Orientation::Other, 1.0, {{{far, -far, 0}, {-far, far, 0}, {0, 0, 0}}}};
  EXPECT_EQ (mapPicture ({ground, damaged}).bytes, mapPicture ({ground}).bytes);
}

namespace {

/** \brief The memory in the line of /proc/self/status with this name [byte]; 0 without
 * such a line. The line has it in kB. */
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

TEST (LabeledCloud, IsSavedWithLessMemoryThanACopyNeeds)
{
#ifdef PCL_OPS_SANITIZED
  GTEST_SKIP() << "sanitizers keep what is freed";
#endif
  // Number of points of 3 bytes each: a copy needs 3 * size.
  constexpr std::size_t size = 4'000'000;
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
    std::ofstream reset ("/proc/self/clear_refs");
    reset << "5" << std::flush; // sets the peak (VmHWM) to VmRSS
    const std::size_t before = statusBytes ("VmRSS");
    const bool is_memory_told = reset && before > 0;
    constexpr bool keeps_color = false;
    saveLabeledCloud (folder / name, cloud, labels, distances, keeps_color);
    if (is_memory_told) {
      EXPECT_LT (statusBytes ("VmHWM") - before, 2 * size) << name;
    }
  }
  const FileCloud saved = loadCloud (folder / "a.pcd");
  const std::vector<double> numbers (labels.begin(), labels.end());
  EXPECT_TRUE (valuesOf (saved, "label") == numbers);
  EXPECT_TRUE (valuesOf (saved, "distance") == numbers);
}
