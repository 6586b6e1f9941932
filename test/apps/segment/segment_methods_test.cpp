// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "segment_program.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

/** \brief The program with a cloud dense enough for every method, room.pcd. */
class SegmentRoom : public Segment {
protected:
  static constexpr int dense_side = 100;

  SegmentRoom()
  {
    pcl::io::savePCDFileBinary (folder_ / "room.pcd", floorAndWall (dense_side));
  }

  nlohmann::json
  planesOf (const std::string& options) const
  {
    return jsonOf ("room.pcd --planes p.json --quiet " + options);
  }

  /** \brief What a run that finds nothing says about it. */
  std::string
  adviceOf (const std::string& arguments) const
  {
    const Outcome done = expectDone (arguments);
    const std::size_t begin = done.out.find ("No plane found: ");
    EXPECT_NE (begin, std::string::npos) << done.out;
    return done.out.substr (std::min (begin, done.out.size()));
  }
};

class SegmentMethods : public SegmentRoom,
                       public testing::WithParamInterface<const char*> {
protected:
  static std::string
  method ()
  {
    return std::string ("--method ") + GetParam() + " ";
  }
};

std::string
methodOf (const testing::TestParamInfo<const char*>& info)
{
  return info.param;
}

INSTANTIATE_TEST_SUITE_P (Every,
                          SegmentMethods,
                          testing::Values ("ops", "fspf", "kht"),
                          methodOf);

TEST_P (SegmentMethods, FindsFloorAndWall)
{
  const LabelledCloud cloud = label ("room.pcd", method() + "--planes p.json");
  const auto json = jsonIn ("p.json");
  ASSERT_EQ (json["planes"].size(), 2u);
  EXPECT_NE (json["planes"][0]["orientation"], json["planes"][1]["orientation"]);
  const int missing = dense_side * dense_side;
  const int wall_top = missing + dense_side;
  const std::set<std::uint32_t> labels{cloud[0].label, cloud[wall_top].label};
  EXPECT_EQ (labels, (std::set<std::uint32_t>{1, 2}));
  EXPECT_EQ (cloud[missing].label, 0u);
}

TEST_F (SegmentRoom, JoinsPlanesWithinTheMergeDistance)
{
  InputCloud floors = floorAndWall (dense_side);
  floors.resize (dense_side * dense_side);
  for (int i = 0; i < dense_side * dense_side; ++i) {
    auto point = floors[static_cast<std::size_t> (i)];
    point.y += 2.5f;
    point.z += 0.03f;
    floors.push_back (point);
  }
  pcl::io::savePCDFileBinary (folder_ / "floors.pcd", floors);
  const std::string options = "floors.pcd --planes p.json --quiet ";
  EXPECT_EQ (jsonOf (options)["planes"].size(), 2u);
  const auto joined = jsonOf (options + "--merge-distance 0.05");
  EXPECT_EQ (joined["planes"].size(), 1u);
  EXPECT_EQ (joined["parameters"]["merge_distance"], 0.05);
}

TEST_P (SegmentMethods, NamesItselfAndItsParametersAsGivenInTheJson)
{
  const std::map<std::string, std::map<std::string, double>> own = {
      {"ops",
       {{"sampling_rate", 0.1}, {"k", 5}, {"min_inliers", 9}, {"probability", 0.9}}},
      {"fspf",
       {{"inner_radius", 0.1},
        {"outer_radius", 0.3},
        {"local_samples", 9},
        {"min_inlier_share", 0.5},
        {"inliers_per_point", 1}}},
      {"kht",
       {{"phi_num", 30},
        {"rho_num", 40},
        {"min_samples", 9},
        {"s_level", 2},
        {"s_alpha", 3},
        {"s_beta", 4}}}};
  std::string options = method() + "--threshold 0.02";
  for (const auto& [key, number] : own.at (GetParam())) {
    std::string option = key;
    std::replace (option.begin(), option.end(), '_', '-');
    options += " --" + option + " " + std::to_string (number);
  }
  const nlohmann::json json = planesOf (options);
  EXPECT_EQ (json["method"], GetParam());
  EXPECT_EQ (json["parameters"]["preset"], "default");
  EXPECT_EQ (json["parameters"]["threshold"], 0.02);
  for (const auto& [name, numbers] : own)
    for (const auto& [key, number] : numbers)
      EXPECT_EQ (json["parameters"].value (key, -1.0),
                 name == GetParam() ? number : -1.0)
          << key;
}

TEST_P (SegmentMethods, LabelsACloudWithoutASingleReading)
{
  InputCloud blind = floorAndWall();
  for (pcl::PointXYZI& point : blind)
    point.z = std::numeric_limits<float>::infinity();
  pcl::io::savePCDFileBinary (folder_ / "blind.pcd", blind);
  const LabelledCloud cloud =
      label ("blind.pcd", method() + "--image p.png --planes p.json");
  EXPECT_EQ (distinct (cloud, 0, 2 * points_of_plane + 1), std::set<std::uint32_t>{0});
}

TEST_F (SegmentRoom, KeepsTheRatioOfTheRadiiWhereOneIsGiven)
{
  const auto inner = planesOf ("--method fspf --inner-radius 0.3")["parameters"];
  EXPECT_EQ (inner["outer_radius"], 0.6);
  const auto outer = planesOf ("--method fspf --outer-radius 0.3")["parameters"];
  EXPECT_EQ (outer["inner_radius"], 0.15);
  const auto both =
      planesOf ("--method fspf --inner-radius 0.2 --outer-radius 0.3")["parameters"];
  EXPECT_EQ (both["inner_radius"], 0.2);
  EXPECT_EQ (both["outer_radius"], 0.3);
}

TEST_F (SegmentRoom, SaysWhichOptionToChangeWhereNothingIsFound)
{
  InputCloud large = floorAndWall();
  for (pcl::PointXYZI& point : large)
    point.getVector3fMap() *= 1000.0f;
  pcl::io::savePCDFileBinary (folder_ / "large.pcd", large);
  using Parts = std::vector<const char*>;
  // Points 4 cm apart: of the 25 nearest on a plane only the corners are 9 cm away.
  const std::pair<const char*, Parts> rows[] = {
      {"in.pcd --preset paper --sampling-rate 0.001",
       {"only 5 of 5000 points", "--sampling-rate"}},
      {"in.pcd --min-inliers 100000 --sampling-rate 1", {"--min-inliers"}},
      {"in.pcd --method fspf --outer-radius 0.09",
       {"--outer-radius 0.09 hold 21 points", "--local-samples 80"}},
      {"in.pcd --method kht --s-level 9", {"--s-level 9", "--min-samples 30"}},
      {"large.pcd --method fspf", {"millimeter", "--inner-radius"}}};
  for (const auto& [arguments, parts] : rows)
    for (const char* part : parts)
      EXPECT_TRUE (contains (adviceOf (arguments), part));
  EXPECT_TRUE (
      contains (run ("large.pcd --method fspf --threshold 50 --inner-radius 200").out,
                "2 planes"));
}

TEST_F (SegmentRoom, SaysThatMinInliersCountsSamplesWhereItLeavesHardlyAPlane)
{
  const auto out_of = [&] (const std::string& options) {
    return run ("in.pcd " + options).out;
  };
  const std::string none = out_of ("--min-inliers 2000");
  EXPECT_TRUE (contains (none,
                         "\n--min-inliers 2000 counts samples, not points, and leaves "
                         "0 of 2 planes: --min-points 2000 counts points\n"));
  for (const char* fitting : {"--min-inliers 21", "--min-points 2000", "--method kht"})
    EXPECT_FALSE (contains (out_of (fitting), "counts samples")) << fitting;
}

TEST_F (SegmentRoom, HasVoxelsOfTheEdgeAskedFor)
{
  const nlohmann::json usual = planesOf (""), given = planesOf ("--cell 0.1");
  EXPECT_EQ (usual.at ("parameters").at ("cell"), 0.0);
  EXPECT_EQ (given.at ("parameters").at ("cell"), 0.1);
  EXPECT_EQ (given.at ("planes").size(), 2u);
  EXPECT_EQ (planesOf ("--cell 1").at ("planes").size(), 0u) << "too few voxels";
}

/** \brief The floor and the wall with a second wall at y = 2 m, x becoming up: the
 * sensor looks along the longest side. */
InputCloud
roomLyingOnItsSide ()
{
  InputCloud cloud;
  const auto add = [&] (float x, float y, float z) {
    // What was up, z, is x now.
    cloud.push_back ({z, x, y, static_cast<float> (cloud.size())});
  };
  constexpr float step = 0.04f;
  for (float x = 0; x < 4; x += step)
    for (float y = 0; y < 2; y += step)
      add (x, y, 0);
  for (float x = 0; x < 4; x += step)
    for (float z = step; z < 1.6f; z += step)
      add (x, 2, z);
  for (float y = 0; y < 2; y += step)
    for (float z = step; z < 1.6f; z += step)
      add (4, y, z);
  cloud.sensor_origin_ = Eigen::Vector4f (1.3f, -1.0f, 0.8f, 0.0f);
  return cloud;
}

/** \brief A run that looks for the up axis, with what it wrote to planes.json. */
struct UpRun {
  Outcome outcome;
  nlohmann::json json;

  Eigen::Vector3d
  up () const
  {
    return toVector (json["parameters"]["up"]);
  }
};

class SegmentUp : public Segment {
protected:
  UpRun
  findUp (const InputCloud& cloud, const std::string& options = "") const
  {
    pcl::io::savePCDFileBinary (folder_ / "cloud.pcd", cloud);
    const Outcome done =
        expectDone ("cloud.pcd --up auto --planes planes.json " + options);
    return {done, jsonIn ("planes.json")};
  }
};

TEST_F (SegmentUp, IsFoundAndNamesThePlanes)
{
  const UpRun run = findUp (roomLyingOnItsSide());
  EXPECT_GE (run.up().x(), 0.999) << run.outcome.out;
  EXPECT_GE (run.json["parameters"]["up_confidence"], 0.7);
  EXPECT_TRUE (contains (run.outcome.out, "Up axis: 1,"));
  EXPECT_TRUE (contains (run.outcome.out, "confidence"));
  for (const auto& plane : run.json["planes"]) {
    const bool is_floor = std::abs (plane["normal"][0].get<double>()) > 0.9;
    EXPECT_EQ (plane["orientation"], is_floor ? "horizontal" : "vertical");
  }
}

TEST_F (SegmentUp, IsTheSameForEveryMethodAndPreset)
{
  for (const char* options :
       {"--preset paper", "--method fspf", "--method kht", "--threads 2"})
    EXPECT_EQ (findUp (roomLyingOnItsSide(), options).up(),
               findUp (roomLyingOnItsSide()).up())
        << options;
}

TEST_F (SegmentUp, SaysWhenThePlanesCannotTell)
{
  InputCloud wall;
  for (int x = 0; x < 60; ++x)
    for (int y = 0; y < 60; ++y)
      wall.push_back (
          {0.04f * static_cast<float> (x), 0.04f * static_cast<float> (y), 2.0f, 0.0f});
  const UpRun run = findUp (wall);
  EXPECT_EQ (run.up(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE (run.json["parameters"]["up_confidence"].is_null());
  EXPECT_TRUE (contains (run.outcome.out, "cannot tell, 0,0,1 is used"));
}

TEST_F (SegmentUp, IsNotGuessedWhereTheViewpointIsNotTheSensors)
{
  // From below the floor, which then stands before all the rest.
  InputCloud cloud = roomLyingOnItsSide();
  cloud.sensor_origin_ = Eigen::Vector4f (-2.0f, 2.0f, 1.0f, 0.0f);
  const UpRun run = findUp (cloud);
  EXPECT_EQ (run.up(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE (run.json["parameters"]["up_confidence"].is_null());
  EXPECT_TRUE (contains (run.outcome.out, "not seen from its VIEWPOINT"));
}

TEST_F (SegmentUp, IsSuggestedWhereThePlanesAreSureOfAnother)
{
  const std::string hint = "planes suggest that up is 1.00, 0.00, 0.00: --up auto";
  const auto says_so = [&] (const std::string& options) {
    return contains (expectDone ("cloud.pcd " + options).out, hint);
  };
  pcl::io::savePCDFileBinary (folder_ / "cloud.pcd", roomLyingOnItsSide());
  const auto suggested = jsonOf ("cloud.pcd --planes p.json")["suggested_up"];
  EXPECT_NEAR (suggested[0].get<double>(), 1.0, 0.01);
  EXPECT_FALSE (
      jsonOf ("cloud.pcd --up 1,0,0 --planes p.json").contains ("suggested_up"));
  EXPECT_TRUE (says_so (""));
  EXPECT_TRUE (says_so ("--output-dir planes"));
  EXPECT_FALSE (says_so ("--up 0,0,1"));
  EXPECT_FALSE (says_so ("--up camera"));
  EXPECT_FALSE (says_so ("--up auto"));
  EXPECT_FALSE (says_so ("--method kht"));
}

TEST_F (SegmentUp, IsNotSuggestedWhereItIsTheOneUsedOrNobodyKnows)
{
  InputCloud upright = roomLyingOnItsSide();
  for (pcl::PointXYZI& point : upright)
    point.getVector3fMap() = Eigen::Vector3f (point.y, point.z, point.x);
  upright.sensor_origin_ = Eigen::Vector4f (-1.0f, 0.8f, 1.3f, 0.0f);
  InputCloud elsewhere = roomLyingOnItsSide();
  elsewhere.sensor_origin_ = Eigen::Vector4f (-2.0f, 2.0f, 1.0f, 0.0f);
  for (const InputCloud& cloud : {upright, elsewhere}) {
    pcl::io::savePCDFileBinary (folder_ / "cloud.pcd", cloud);
    EXPECT_FALSE (contains (expectDone ("cloud.pcd").out, "suggest"));
  }
}

TEST_F (SegmentUp, IsNotLookedForUnlessAsked)
{
  const auto json = jsonOf ("in.pcd --planes planes.json", "planes.json");
  EXPECT_FALSE (json["parameters"].contains ("up_confidence"));
}

} // namespace
