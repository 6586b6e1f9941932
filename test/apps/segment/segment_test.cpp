// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>

#include <Eigen/Geometry>

#include "segment_program.h"
#include "text_clouds.h"
#include <detection/plane_list.h>
#include <io/las_file.h>
#include <support/answers.h>

#include <optional>
#include <tuple>

namespace {

using Eigen::Vector3f;

// Steps of 4 cm along the axes.
const Vector3f x = 0.04f * Vector3f::UnitX(), y = 0.04f * Vector3f::UnitY(),
               z = 0.04f * Vector3f::UnitZ();

/** \brief The floor, the point of NaN, and a wall at x = 3 m with this many columns of
 * points. */
InputCloud
withColumns (int columns)
{
  InputCloud cloud = floorAndWall();
  cloud.resize (points_of_plane + 1);
  addGrid (cloud, {3, 0, 0}, y, columns, z, points_of_side);
  return cloud;
}

/** \brief A floor, half of it 13 mm higher; every second point is 1 cm higher. */
InputCloud
twoFloors ()
{
  InputCloud cloud;
  addGrid (cloud, {0, 0, 0}, x, 150, y, 60);
  addGrid (cloud, {6, 0, 0.013f}, x, 150, y, 60);
  for (std::size_t i = 0; i < cloud.size(); i += 2)
    cloud[i].z += 0.01f;
  return cloud;
}

/** \brief The floor and two table tops, both 0.7 m high and with a gap of 1 m. They
 * have 40 x 40 and 30 x 40 points. */
InputCloud
twoTables ()
{
  InputCloud cloud = floorAndWall();
  cloud.resize (points_of_plane);
  addGrid (cloud, {0, 0, 0.7f}, x, 40, y, 40);
  addGrid (cloud, {2.56f, 0, 0.7f}, x, 30, y, 40);
  return cloud;
}

/** \brief A floor and two walls; up is x. The room is longest along y. The sensor is
 * outside of it, at y = -1 m, where a wall is missing. */
InputCloud
roomLyingOnItsSide ()
{
  InputCloud cloud;
  addGrid (cloud, {0, 0, 0}, y, 100, z, 50);
  addGrid (cloud, {0.04f, 0, 2}, y, 100, x, 39);
  addGrid (cloud, {0.04f, 4, 0}, z, 50, x, 39);
  cloud.sensor_origin_ = Eigen::Vector4f (1.3f, -1.0f, 0.8f, 0.0f);
  return cloud;
}

InputCloud
moved (InputCloud cloud, const Eigen::Matrix3f& turn, const Vector3f& shift = {0, 0, 0})
{
  for (pcl::PointXYZI& point : cloud)
    point.getVector3fMap() = Vector3f (turn * point.getVector3fMap() + shift);
  return cloud;
}

/** \brief A wall alone, at an x of 500 km, where single precision has steps of 3 cm.
 * Its points are 0, 2 and 4 mm farther along x by turns. */
LasRecipe
roughWall ()
{
  LasRecipe recipe = floorAndWallInLas();
  recipe.points.erase (recipe.points.begin(), recipe.points.begin() + points_of_plane);
  for (int i = 0; i < points_of_plane; ++i)
    recipe.points[i][0] += 2 * (i % 3);
  return recipe;
}

/** \brief The bytes of a scan of KITTI: x, y, z, intensity. */
std::string
scanOfKitti (const InputCloud& cloud)
{
  std::string bytes;
  for (const pcl::PointXYZI& point : cloud)
    for (const float number : {point.x, point.y, point.z, point.intensity})
      bytes.append (reinterpret_cast<const char*> (&number), sizeof (number));
  return bytes;
}

/** \brief A wall of 3 m x 2 m at y = 2 m with a window of 1 m x 0.8 m. Points are 2 cm
 * apart. */
InputCloud
wallWithWindow ()
{
  InputCloud wall;
  const Vector3f across (0.02f, 0, 0), upwards (0, 0, 0.02f);
  addGrid (wall, {0, 2, 0}, across, 151, upwards, 41);    // below the window
  addGrid (wall, {0, 2, 1.6f}, across, 151, upwards, 21); // above it
  addGrid (wall, {0, 2, 0.82f}, across, 51, upwards, 39); // beside it
  addGrid (wall, {2, 2, 0.82f}, across, 51, upwards, 39);
  return wall;
}

/** \brief A folder with the clouds of answers.tsv. */
class SegmentAnswers : public AnswersFolder {
protected:
  SegmentAnswers() : AnswersFolder (PCL_OPS_SEGMENT_PROGRAM)
  {
    saveKindsOfFiles();
    saveTexts();
    saveScenes();
    saveRooms();
    saveSequences();
  }

  void
  save (const std::string& file,
        InputCloud cloud,
        const std::optional<Vector3f>& sensor = {}) const
  {
    if (sensor)
      cloud.sensor_origin_.head<3>() = *sensor;
    pcl::io::savePCDFileBinary (folder_ / file, cloud);
  }

  void
  saveKindsOfFiles () const
  {
    const InputCloud cloud = floorAndWall();
    save ("in.pcd", cloud);
    pcl::io::savePCDFileASCII (folder_ / "ascii.pcd", cloud);
    pcl::io::savePCDFileBinaryCompressed (folder_ / "compressed.pcd", cloud);
    // A PLY loses the sensor's pose, which the labels do not depend on.
    pcl::io::savePLYFileASCII (folder_ / "ascii.ply", cloud);
    pcl::io::savePLYFileBinary (folder_ / "binary.ply", cloud);
    folder_.write ("in.las", lasBytes (floorAndWallInLas()));
    // All have the same numbers, whatever their unit.
    const auto writeWithKeys =
        [this] (const char* file,
                const std::vector<std::array<std::uint16_t, 2>>& keys) {
          folder_.write (file, lasBytes (floorAndWallWithKeys (keys)));
        };
    writeWithKeys ("feet.las",
                   {{projected_system, oregon_in_feet}, {linear_unit, unit_foot}});
    writeWithKeys ("number.las", {{projected_system, california_in_us_feet}});
    writeWithKeys ("high.las",
                   {{linear_unit, unit_meter}, {vertical_unit, unit_us_foot}});
    writeWithKeys (
        "low.las",
        {{projected_system, california_in_us_feet}, {vertical_unit, unit_meter}});
    folder_.write ("rough.las", lasBytes (roughWall()));
    if (pcl_ops::apps::hasLaszip()) {
      std::ofstream stream (folder_ / "in.laz", std::ios::binary);
      pcl_ops::apps::compressLas (folder_ / "in.las", stream);
    }
    folder_.write ("in.csv", "x,y,z,number\n" + squareText (50, 120.789, ","));
    folder_.write ("utm.xyz", squareText (points_of_side, 100));
  }

  void
  saveTexts () const
  {
    folder_.write ("north_east.xyz", slopeText (1, 1));
    folder_.write ("south_east.xyz", slopeText (1, -1));
    folder_.write ("south_west.xyz", slopeText (-1, -1));
    folder_.write ("north_west.xyz", slopeText (-1, 1));
    folder_.write ("lonlat.xyz", degreesText());
    folder_.write ("columns.csv", columnsText());
    folder_.write ("odd.pcd", pcdOfManyTypes());
    folder_.write ("one.ptx", scanText (99, 1));
    folder_.write ("two.ptx", scanText (99, 1) + scanText (104, -1));
    folder_.write ("floor.off", offText());
    folder_.write ("far.pcd", farCornerText());
    folder_.write ("window.xyz", windowText());
    folder_.write ("tilted.xyz", tiltedFloorText());
    folder_.write ("with_names.xyz",
                   "# of today\neasting [m],north,h,i\n" + squareText (50, 100, ","));
    std::filesystem::create_directory (folder_ / "texts");
    // Texts that begin with the mark of UTF-8 (BOM).
    for (const char* name : {"a.txt", "b.xyz", "notes.csv"})
      folder_.write (std::string ("texts/") + name,
                     "\357\273\277" + squareText (50, 100));
  }

  void
  saveScenes () const
  {
    InputCloud scene = withColumns (40);
    // Three points above each other, on no plane.
    addGrid (scene, {1.0f, 1.0f, 0.7f}, {0, 0, 0.3f}, 3, {0, 0, 0}, 1);
    save ("scene.pcd", scene);
    InputCloud board = withColumns (0);
    board.resize (points_of_plane);
    // A board that rises by 30 degrees, whose tangent is 0.57735.
    addGrid (board, {0, 0, 2}, {0, 0.01f, 0}, 30, {0.02f, 0, 0.02f * 0.57735f}, 50);
    save ("board.pcd", board);
    save ("ceiling.pcd", floorAndWall(), Vector3f (0.5f, 1.0f, -2.0f));
    InputCloud floors = floorAndWall (100);
    save ("room.pcd", floors);
    // A second floor beside the first one, 3 cm higher.
    floors.resize (100 * 100);
    addGrid (floors, {0, 2.5f, 0.03f}, {0.02f, 0, 0}, 100, {0, 0.02f, 0}, 100);
    save ("floors.pcd", floors);
    save ("tables.pcd", twoTables());
    save ("two_floors.pcd", twoFloors());
    InputCloud boards;
    for (const float depth : {1.0f, 2.0f, 3.0f, 4.0f})
      addGrid (boards, {-1, depth, 0}, 0.5f * x, 100, 0.5f * z, 100);
    save ("boards.pcd", boards, Vector3f (0, -1, 1));
    save ("large.pcd", moved (floorAndWall(), 1000 * Eigen::Matrix3f::Identity()));
    InputCloud blind = floorAndWall(), damaged = blind, rough = blind;
    for (pcl::PointXYZI& point : blind)
      point.z = std::numeric_limits<float>::infinity();
    save ("blind.pcd", blind);
    for (std::size_t i = points_of_plane; i < damaged.size(); ++i)
      damaged[i].getVector3fMap().setZero();
    save ("damaged.pcd", damaged);
    InputCloud zeros = floorAndWall();
    zeros.resize (zeros.size() + 100, pcl::PointXYZI());
    save ("zeros.pcd", zeros);
    for (int i = 0; i < points_of_plane; ++i)
      rough[i].z = 0.002f * static_cast<float> (i % 3);
    save ("rough.pcd", rough);
  }

  void
  saveRooms () const
  {
    const InputCloud room = roomLyingOnItsSide();
    save ("lying.pcd", room);
    // A sensor below the floor (up is x): the floor would hide the rest of the room.
    save ("elsewhere.pcd", room, Vector3f (-2.0f, 2.0f, 1.0f));
    Eigen::Matrix3f turn;
    turn << 0, 1, 0, 0, 0, 1, 1, 0, 0; // x, which is up, becomes z
    save ("upright.pcd", moved (room, turn), Vector3f (-1.0f, 0.8f, 1.3f));
    InputCloud wall;
    addGrid (wall, {0, 0, 2}, x, 60, y, 60);
    save ("wall.pcd", wall);
  }

  /** \brief In the second and the third scan of track the wall is larger than the
   * floor: without tracking the planes would swap numbers. The sensor of the third scan
   * has moved by 1 m in x. */
  void
  saveSequences () const
  {
    const InputCloud larger = withColumns (70);
    const Eigen::Matrix3f no_turn = Eigen::Matrix3f::Identity();
    std::filesystem::create_directory (folder_ / "track");
    std::filesystem::create_directory (folder_ / "drive");
    for (const char* name : {"drive/a.bin", "drive/b.bin"})
      folder_.write (name, scanOfKitti (floorAndWall (100)));
    save ("track/a.pcd", withColumns (40));
    save ("track/b.pcd", larger);
    save ("track/c.pcd", moved (larger, no_turn, {-1, 0, 0}));
    folder_.write ("poses.txt",
                   "# timestamp tx ty tz qx qy qz qw\n0.0 0 0 0 0 0 0 1\n\n"
                   "0.1 0 0 0 0 0 0 1\n0.2 1 0 0 0 0 0 1\n");
    // The sensor of this scan lies on its side: its y is z of the others.
    Eigen::Matrix3f turn;
    turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    save ("turned.pcd", moved (larger, turn), Vector3f (0.5f, 1.5f, -1.0f));
    save ("dense.pcd", floorAndWall (300));
    folder_.write ("low.xyz", squareText (50, 0.0));
    folder_.write ("both.xyz", squareText (50, 0.0) + squareText (75, 2.0));
    folder_.write ("high.xyz", squareText (50, 0.5));
  }
};

struct Mesh {
  std::vector<Eigen::Vector3d> points;
  /** \brief The corners of each face. */
  std::vector<std::vector<std::size_t>> faces;

  double
  area () const
  {
    double area = 0.0;
    for (const std::vector<std::size_t>& face : faces)
      for (std::size_t k = 2; k < face.size(); ++k) {
        const Eigen::Vector3d first = points.at (face[0]);
        area += 0.5 * (points.at (face[k - 1]) - first)
                          .cross (points.at (face[k]) - first)
                          .norm();
      }
    return area;
  }
};

/** \brief Reads a .ply or .vtk in text without the code that wrote it: each line of
 * numbers alone is a point, and behind the last point a face. */
Mesh
readMesh (const std::string& text)
{
  std::smatch points;
  std::regex_search (text, points, std::regex ("(?:element vertex|POINTS) ([0-9]+)"));
  // In a .vtk, colors follow behind POINT_DATA.
  std::istringstream stream (text.substr (0, text.find ("POINT_DATA")));
  Mesh mesh;
  for (std::string line; std::getline (stream, line);) {
    if (line.find_first_not_of ("0123456789.e+- ") < line.size())
      continue;
    const std::vector<double> numbers = numbersIn (line);
    if (mesh.points.size() < std::stoul (points[1]))
      mesh.points.emplace_back (numbers.at (0), numbers.at (1), numbers.at (2));
    else // the number of corners, and their indices
      mesh.faces.emplace_back (numbers.begin() + 1, numbers.end());
  }
  return mesh;
}

constexpr bool has_concave_hulls = PCL_OPS_WITH_SURFACE != 0;

INSTANTIATE_TEST_SUITE_P (All,
                          SegmentAnswers,
                          testing::ValuesIn (answersIn (PCL_OPS_ANSWERS)),
                          nameOfAnswers);

} // namespace

TEST_P (SegmentAnswers, AreThoseOfTheTable)
{
  expectAnswers ({{"with LASzip:", pcl_ops::apps::hasLaszip()},
                  {"without LASzip:", !pcl_ops::apps::hasLaszip()},
                  {"with concave hulls:", has_concave_hulls},
                  {"without concave hulls:", !has_concave_hulls}});
}

TEST_F (Segment, WritesDistancesBehindTheRecordsOfALas)
{
  // The test reads the bytes: no program of the project reads distances of a LAS.
  folder_.write ("rough.las", lasBytes (roughWall()));
  expectDone ("rough.las out.las --distances");
  std::string las = contentOf (folder_ / "out.las");
  const LasHeader& header = headerIn (las);
  const auto distanceOf = [&] (std::size_t i) -> float {
    const std::size_t end = header.points_offset + (i + 1) * header.record_length;
    return reinterpret_cast<boost::endian::little_float32_t&> (las[end - 4]);
  };
  // Which side of the wall is positive is not fixed.
  const float first = std::copysign (0.002f, distanceOf (0));
  for (int i = 0; i < points_of_plane; ++i)
    ASSERT_NEAR (distanceOf (i), first * static_cast<float> (1 - i % 3), 2e-4f) << i;
}

TEST_F (Segment, WritesHullsAsAMeshThatLiesOnTheCloudInPclViewer)
{
  // pcl_viewer moves a cloud by the pose of its sensor, but not a mesh in .vtk. So the
  // mesh has to be written with the pose applied.
  InputCloud posed = floorAndWall();
  posed.sensor_orientation_ = Eigen::AngleAxisf (0.5f, Eigen::Vector3f::UnitY());
  save ("posed.pcd", posed);
  folder_.write ("utm.las", lasBytes (floorAndWallInLas()));
  save ("wall.pcd", wallWithWindow());
  const std::string concave = has_concave_hulls ? " --hull concave" : "";
  const Eigen::Isometry3d not_moved = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d pose =
      Eigen::Translation3d (posed.sensor_origin_.head<3>().cast<double>()) *
      posed.sensor_orientation_.cast<double>();
  for (const auto& [cloud, file, motion] :
       {std::tuple ("posed.pcd", "m.ply", not_moved),
        std::tuple ("posed.pcd", "m.vtk", pose),
        std::tuple ("utm.las", "m.ply", not_moved),
        std::tuple ("utm.las", "m.vtk", not_moved),
        std::tuple ("wall.pcd", "m.ply", not_moved)}) {
    SCOPED_TRACE (cloud + std::string (" ") + file);
    const auto json = nlohmann::json::parse (
        expectDone (cloud + concave + " --planes - --mesh " + file).out);
    ASSERT_FALSE (json["planes"].empty());
    const Mesh mesh = readMesh (contentOf (folder_ / file));
    EXPECT_GE (mesh.faces.size(), json["planes"].size());
    double area = 0.0;
    std::size_t i = 0;
    for (nlohmann::json plane : json["planes"]) {
      area += plane["area"].get<double>();
      plane["holes"].insert (plane["holes"].begin(), plane["hull"]);
      for (const nlohmann::json& ring : plane["holes"])
        for (const nlohmann::json& corner : ring)
          EXPECT_LT (
              (mesh.points.at (i++) - motion * corner.get<Eigen::Vector3d>()).norm(),
              1e-5);
    }
    EXPECT_EQ (i, mesh.points.size());
    EXPECT_NEAR (mesh.area(), area, 1e-3) << "no face in the window";
  }
}

TEST_F (Segment, HasAHelpThatFitsOnOneScreen)
{
  const std::string help = expectDone ("--help").out;
  EXPECT_TRUE (contains (help, "--help"));
  EXPECT_LE (lines (help), 50u);
  std::istringstream stream (help);
  for (std::string line; std::getline (stream, line);)
    EXPECT_LE (line.size(), 80u) << line;
}

/** \brief A folder of five clouds and a broken one. */
class SegmentJobs : public Segment {
protected:
  SegmentJobs()
  {
    std::filesystem::create_directory (folder_ / "scans");
    for (const char* name : {"a", "b", "c", "d", "e"})
      save (std::string ("scans/") + name + ".pcd", floorAndWall());
    folder_.write ("scans/bad.pcd", "no cloud\n");
  }

  /** \brief Segments the folder, and then renames the folder of outputs. */
  Outcome
  segment (const std::string& options, const std::string& moved_to) const
  {
    const Outcome done =
        shell ("pcl_ops_segment scans --output-dir out --rest {}_rest.pcd " + options);
    EXPECT_EQ (done.exit_code, 1) << "for the broken cloud";
    std::filesystem::rename (folder_ / "out", folder_ / moved_to);
    return done;
  }
};

TEST_F (SegmentJobs, WriteTheSameInTheOrderOfTheInputsWhateverTheirNumber)
{
  const Outcome by_one = segment ("", "one");
  EXPECT_EQ (lines (by_one.out), 5u);
  for (const char* jobs : {"4", "0"}) {
    SCOPED_TRACE (jobs);
    const std::string folder = std::string ("jobs_") + jobs;
    const Outcome several = segment (std::string ("--jobs ") + jobs, folder);
    EXPECT_EQ (several.out, by_one.out);
    EXPECT_EQ (several.err, by_one.err);
    // Lists of planes in JSON hold durations, which differ.
    const Outcome same = shell ("diff -r -x '*.json' one " + folder);
    EXPECT_EQ (same.exit_code, 0) << same.out;
  }
}

TEST_F (Segment, DrawsTheCornerOnceAtWhichAllEdgesEnd)
{
  // Three planes meet in three edges and one corner. The vertices of the .ply are the
  // corner, which is the first, and the other ends of the edges.
  folder_.write ("far.pcd", farCornerText());
  expectDone ("far.pcd --edges e.ply");
  const std::string ply = contentOf (folder_ / "e.ply");
  std::istringstream body (ply.substr (ply.find ("end_header\n") + 11));
  std::string corner;
  std::getline (body, corner);
  const std::vector<double> position = numbersIn (corner);
  EXPECT_NEAR (position.at (0), 448'261.25, 0.01);
  EXPECT_NEAR (position.at (1), 5'411'932.5, 0.1);
  EXPECT_NEAR (position.at (2), 312.125, 0.005);
  std::string line;
  for (int other_end = 1; other_end <= 3; ++other_end)
    std::getline (body, line);
  std::set<std::pair<double, double>> planes;
  for (int edge = 0; edge < 3; ++edge) {
    std::getline (body, line);
    const std::vector<double> numbers = numbersIn (line); // two ends, two planes
    EXPECT_EQ (std::min (numbers.at (0), numbers.at (1)), 0.0) << "the corner";
    planes.emplace (numbers.at (2), numbers.at (3));
  }
  EXPECT_EQ (planes,
             (std::set<std::pair<double, double>>{{1.0, 2.0}, {1.0, 3.0}, {2.0, 3.0}}));
}
