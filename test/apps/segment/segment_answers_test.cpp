// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace {

using Json = nlohmann::json;

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

/** \brief Whether two values are the same but for rounded numbers. */
bool
isNear (const Json& value, const Json& expected)
{
  if (value.is_number() && expected.is_number())
    return std::abs (value.get<double>() - expected.get<double>()) < 1e-3;
  if (!value.is_array() || value.size() != expected.size())
    return value == expected;
  return std::equal (value.begin(), value.end(), expected.begin(), isNear);
}

/** \brief A folder with the clouds of answers.tsv. */
class Answers : public Segment {
protected:
  Answers()
  {
    const InputCloud scene = floorAndWall();
    InputCloud board = scene;
    board.resize (points_of_plane);
    addGrid (board, {0, 0, 2}, {0, 0.01f, 0}, 30, {0.02f, 0, 0.02f * 0.57735f}, 50);
    save ("board.pcd", board);
    InputCloud floors = floorAndWall (100);
    save ("room.pcd", floors);
    floors.resize (100 * 100);
    addGrid (floors, {0, 2.5f, 0.03f}, {0.02f, 0, 0}, 100, {0, 0.02f, 0}, 100);
    save ("floors.pcd", floors);
    save ("large.pcd", moved (scene, 1000 * Eigen::Matrix3f::Identity()));
    InputCloud blind = scene;
    for (pcl::PointXYZI& point : blind)
      point.z = std::numeric_limits<float>::infinity();
    save ("blind.pcd", blind);
    constexpr float rise = 0.04f * 0.70711f;
    for (const auto& [name, x, y] :
         {std::tuple ("slope_north_east.pcd", -rise, -rise),
          std::tuple ("slope_south_east.pcd", -rise, rise),
          std::tuple ("slope_south_west.pcd", rise, rise),
          std::tuple ("slope_north_west.pcd", rise, -rise)}) {
      InputCloud slope;
      addGrid (slope, {0, 0, 3}, {0.04f, 0, x}, 50, {0, 0.04f, y}, 50);
      save (name, slope);
    }
    saveRooms();
    folder_.write ("utm.xyz", squareText (points_of_side, 100));
    folder_.write ("one.xyz", "1 2 3\n");
    folder_.write ("two.xyz", "1 2 3\n1 2 4\n");
    folder_.write ("three.xyz", "1 2 3\n1 2 4\n1 3 3\n");
  }

  void
  saveRooms () const
  {
    InputCloud room = roomLyingOnItsSide();
    save ("lying.pcd", room);
    // From below the floor, which then stands before all the rest.
    room.sensor_origin_ = Eigen::Vector4f (-2.0f, 2.0f, 1.0f, 0.0f);
    save ("elsewhere.pcd", room);
    Eigen::Matrix3f turn;
    turn << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    room = moved (roomLyingOnItsSide(), turn);
    room.sensor_origin_ = Eigen::Vector4f (-1.0f, 0.8f, 1.3f, 0.0f);
    save ("upright.pcd", room);
    InputCloud wall;
    addGrid (wall, {0, 0, 2}, {0.04f, 0, 0}, 60, {0, 0.04f, 0}, 60);
    save ("wall.pcd", wall);
  }

  static InputCloud
  moved (InputCloud cloud, const Eigen::Matrix3f& by)
  {
    for (pcl::PointXYZI& point : cloud)
      point.getVector3fMap() = Eigen::Vector3f (by * point.getVector3fMap());
    return cloud;
  }

  /** \brief Looks at a value in JSON; at the number of values where \p pointer ends
   * with ".size". */
  static void
  expectValue (const Json& json, std::string pointer, const std::string& expected)
  {
    const std::size_t end = pointer.find (".size");
    const bool is_size = end != std::string::npos;
    const Json::json_pointer place (pointer.substr (0, end));
    if (expected == "absent")
      EXPECT_FALSE (json.contains (place)) << json[place];
    else if (json.contains (place))
      EXPECT_TRUE (isNear (is_size ? Json (json[place].size()) : json[place],
                           Json::parse (expected)))
          << json[place] << " is not " << expected;
    else
      ADD_FAILURE() << "is missing";
  }
};

} // namespace

TEST_F (Answers, AreThoseOfTheTable)
{
  std::string arguments, last, out;
  for (const auto& row : tableIn (PCL_OPS_ANSWERS)) {
    const std::string &where = row.at (1), &what = row.at (2);
    if (!row[0].empty())
      arguments = row[0];
    const std::size_t pointer = where.find ('#');
    const std::string command = arguments + (pointer == 0 ? " --planes -" : "");
    SCOPED_TRACE (command + ": " + where);
    if (command != last)
      out = expectDone (command).out;
    last = command;
    const bool is_absent = where[0] == '!';
    const std::string file = where.substr (is_absent ? 1 : 0, pointer);
    const std::string text =
        file.empty() || file == "out" ? out : contentOf (folder_ / file);
    if (pointer != std::string::npos)
      expectValue (Json::parse (text), where.substr (pointer + 1), what);
    else
      EXPECT_EQ (text.find (Json::parse ('"' + what + '"').get<std::string>()) ==
                     std::string::npos,
                 is_absent)
          << text;
  }
}
