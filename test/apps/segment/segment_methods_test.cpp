// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

constexpr int dense_side = 100;

/** \brief The program with a cloud dense enough for every method, room.pcd. */
class SegmentMethods : public Segment {
protected:
  SegmentMethods() { save ("room.pcd", floorAndWall (dense_side)); }
};

TEST_F (SegmentMethods, FindFloorAndWallAndNoneWhereThereIsNoReading)
{
  InputCloud blind = floorAndWall();
  for (pcl::PointXYZI& point : blind)
    point.z = std::numeric_limits<float>::infinity();
  save ("blind.pcd", blind);
  for (const std::string method : {"--method ops", "--method fspf", "--method kht"}) {
    SCOPED_TRACE (method);
    const LabelledCloud cloud = label ("room.pcd", method + " --planes p.json");
    const auto planes = jsonIn ("p.json")["planes"];
    ASSERT_EQ (planes.size(), 2u);
    EXPECT_NE (planes[0]["orientation"], planes[1]["orientation"]);
    const std::size_t missing = dense_side * dense_side;
    EXPECT_EQ (cloud[0].label + cloud[missing + dense_side].label, 3u);
    EXPECT_EQ (cloud[missing].label, 0u);
    const LabelledCloud none = label ("blind.pcd", method + " --image p.png");
    EXPECT_EQ (distinct (labelsOf (none), 0, static_cast<int> (none.size())),
               std::set<std::uint32_t>{0});
  }
}

TEST_F (SegmentMethods, NameThemselvesAndTheirParametersAsGivenInTheJson)
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
  for (const auto& [method, of_method] : own) {
    SCOPED_TRACE (method);
    std::string options = "--method " + method + " --threshold 0.02";
    for (const auto& [key, number] : of_method) {
      std::string option = key;
      std::replace (option.begin(), option.end(), '_', '-');
      options += " --" + option + " " + std::to_string (number);
    }
    const auto json = jsonOf ("room.pcd " + options);
    EXPECT_EQ (json["method"], method);
    EXPECT_EQ (json["parameters"]["preset"], "default");
    EXPECT_EQ (json["parameters"]["threshold"], 0.02);
    for (const auto& [name, numbers] : own)
      for (const auto& [key, number] : numbers)
        EXPECT_EQ (json["parameters"].value (key, -1.0), name == method ? number : -1.0)
            << key;
  }
}

TEST_F (SegmentMethods, TakeParametersAtTheirWordAndReportThem)
{
  InputCloud floors = floorAndWall (dense_side);
  floors.resize (dense_side * dense_side);
  addGrid (floors, {0, 2.5f, 0.03f}, {0.02f, 0, 0}, 100, {0, 0.02f, 0}, 100);
  save ("floors.pcd", floors);
  const struct {
    const char *arguments, *key;
    nlohmann::json value;
    std::size_t planes;
  } rows[] = {{"floors.pcd", "merge_distance", "auto", 2},
              {"floors.pcd --merge-distance 0.05", "merge_distance", 0.05, 1},
              {"room.pcd --method fspf --inner-radius 0.3", "outer_radius", 0.6, 2},
              {"room.pcd --method fspf --outer-radius 0.3", "inner_radius", 0.15, 2},
              {"room.pcd --method fspf --inner-radius 0.2 --outer-radius 0.3",
               "inner_radius",
               0.2,
               2},
              {"room.pcd", "cell", 0.0, 2},
              {"room.pcd --cell 0.1", "cell", 0.1, 2},
              {"room.pcd --cell 1", "cell", 1.0, 0}, // too few voxels
              {"room.pcd --angle-tolerance 90", "angle_tolerance", 90.0, 2},
              {"room.pcd --direction 0,0,1 --within 90", "within", 90.0, 2}};
  for (const auto& [arguments, key, value, planes] : rows) {
    const auto json = jsonOf (arguments);
    EXPECT_EQ (json["parameters"][key], value) << arguments;
    EXPECT_EQ (json["planes"].size(), planes) << arguments;
  }
}

/** \brief The floor and the wall with a second wall at y = 2 m, x becoming up: the
 * sensor looks along the longest side. */
InputCloud
roomLyingOnItsSide ()
{
  constexpr float step = 0.04f;
  const Eigen::Vector3f x (0, step, 0), y (0, 0, step), up (step, 0, 0);
  InputCloud cloud;
  addGrid (cloud, {0, 0, 0}, x, 100, y, 50);
  addGrid (cloud, {step, 0, 2}, x, 100, up, 39);
  addGrid (cloud, {step, 4, 0}, y, 50, up, 39);
  cloud.sensor_origin_ = Eigen::Vector4f (1.3f, -1.0f, 0.8f, 0.0f);
  return cloud;
}

/** \brief A run that looks for the up axis, with what it wrote to planes.json. */
struct UpRun {
  std::string said;
  nlohmann::json json;
  Eigen::Vector3d up;
};

class SegmentUp : public Segment {
protected:
  SegmentUp()
  {
    save ("lying.pcd", roomLyingOnItsSide());
    // From below the floor, which then stands before all the rest.
    InputCloud elsewhere = roomLyingOnItsSide();
    elsewhere.sensor_origin_ = Eigen::Vector4f (-2.0f, 2.0f, 1.0f, 0.0f);
    save ("elsewhere.pcd", elsewhere);
  }

  UpRun
  findUp (const std::string& arguments) const
  {
    const std::string said =
        expectDone (arguments + " --up auto --planes planes.json").out;
    const auto json = jsonIn ("planes.json");
    return {said, json, toVector (json["parameters"]["up"])};
  }
};

TEST_F (SegmentUp, IsFoundAndNamesThePlanes)
{
  const UpRun run = findUp ("lying.pcd");
  EXPECT_GE (run.up.x(), 0.999) << run.said;
  EXPECT_GE (run.json["parameters"]["up_confidence"], 0.7);
  EXPECT_TRUE (contains (run.said, "Up axis: 1,"));
  EXPECT_TRUE (contains (run.said, "confidence"));
  for (const auto& plane : run.json["planes"]) {
    const bool is_floor = std::abs (plane["normal"][0].get<double>()) > 0.9;
    EXPECT_EQ (plane["orientation"], is_floor ? "horizontal" : "vertical");
  }
  for (const std::string options :
       {"--preset paper", "--method fspf", "--method kht", "--threads 2"})
    EXPECT_EQ (findUp ("lying.pcd " + options).up, run.up) << options;
}

TEST_F (SegmentUp, IsNotGuessedWhereThePlanesOrTheViewpointCannotTell)
{
  InputCloud wall;
  addGrid (wall, {0, 0, 2}, {0.04f, 0, 0}, 60, {0, 0.04f, 0}, 60);
  save ("wall.pcd", wall);
  for (const auto& [cloud, reason] :
       {std::pair ("wall.pcd", "cannot tell, 0,0,1 is used"),
        std::pair ("elsewhere.pcd", "not seen from its VIEWPOINT")}) {
    const UpRun run = findUp (cloud);
    EXPECT_EQ (run.up, Eigen::Vector3d::UnitZ());
    EXPECT_TRUE (run.json["parameters"]["up_confidence"].is_null());
    EXPECT_TRUE (contains (run.said, reason));
  }
}

TEST_F (SegmentUp, IsSuggestedWhereThePlanesAreSureOfAnother)
{
  InputCloud upright = roomLyingOnItsSide();
  for (pcl::PointXYZI& point : upright)
    point.getVector3fMap() = Eigen::Vector3f (point.y, point.z, point.x);
  upright.sensor_origin_ = Eigen::Vector4f (-1.0f, 0.8f, 1.3f, 0.0f);
  save ("upright.pcd", upright);
  for (const char* arguments : {"lying.pcd", "lying.pcd --output-dir planes"})
    EXPECT_TRUE (contains (expectDone (arguments).out,
                           "planes suggest that up is 1.00, 0.00, 0.00: --up auto"));
  for (const char* arguments : {"lying.pcd --up 0,0,1",
                                "lying.pcd --up camera",
                                "lying.pcd --up auto",
                                "lying.pcd --method kht",
                                "upright.pcd",
                                "elsewhere.pcd"})
    EXPECT_FALSE (contains (expectDone (arguments).out, "suggest")) << arguments;
  EXPECT_NEAR (jsonOf ("lying.pcd")["suggested_up"][0].get<double>(), 1.0, 0.01);
  EXPECT_FALSE (jsonOf ("lying.pcd --up 1,0,0").contains ("suggested_up"));
}

} // namespace
