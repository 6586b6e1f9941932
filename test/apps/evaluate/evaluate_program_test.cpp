// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <numbers/random.h>
#include <support/answers.h>
#include <support/labeled_floor.h>

#include <array>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/** A folder with the files of answers.tsv. */
class EvaluateProgram : public AnswersFolder {
protected:
  EvaluateProgram() : AnswersFolder (PCL_OPS_EVALUATE_PROGRAM)
  {
    fs::copy (PCL_OPS_INPUTS, folder_.path(), fs::copy_options::recursive);
    writeFloors();
    writeStreets();
    writeNoisyClouds();
    folder_.write ("one_pose.txt", "0 0 0 0 0 0 0 1\n");
    folder_.write ("brace.json", "{");
    folder_.write ("numbers.json", "[1]");
    folder_.write ("planes_3.json", R"({"planes": 3})");
  }

private:
  static constexpr int no_plane = 0;

  void
  writeFloors () const
  {
    const std::string floor = floorOfOnePlane();
    folder_.write ("floor.xyz", floor);
    folder_.write ("halves.xyz", floorOfTwoPlanes());
    folder_.write ("none.xyz", labeledFloor ([] (int) { return no_plane; }));
    folder_.write ("larger.xyz", floor + "1,1,1,1\n");
    folder_.write ("moved.xyz", withFirstPoint ("9,0,0,1", floor));
    folder_.write ("broken.xyz", withFirstPoint ("0,0,0,1.5", floor));
    folder_.write ("incomplete.xyz", withFirstFivePoints ("nan,0,0,1\n"));
    folder_.write ("incomplete_found.xyz", withFirstFivePoints ("nan,0,0,0\n"));
  }

  void
  writeStreets () const
  {
    constexpr int road = 40, building = 50, vegetation = 70; // classes
    constexpr int ground = 1, roof = 2;                      // planes
    folder_.write ("street.xyz", street (road, road, building, vegetation, vegetation));
    folder_.write ("street_planes.xyz",
                   street (ground, ground, roof, no_plane, no_plane));
    folder_.write ("street_half.xyz",
                   street (no_plane, ground, roof, no_plane, no_plane));
    folder_.write ("street_hedge.xyz", street (ground, ground, roof, ground, no_plane));
    folder_.write ("bare.xyz", "x,y,z\n0,0,0\n");
  }

  /** A road of 20 x 20 points, 25 cm apart; a roof of 20 x 10 points, 6 m above the
   * near half of the road; and a hedge, a column of 50 points beside a corner of the
   * road. The parameters are labels.
   * \param[in] near,far of the halves of the road
   * \param[in] foot,hedge of the hedge's lowest five points and of its other points */
  static std::string
  street (int near, int far, int roof, int foot, int hedge)
  {
    std::ostringstream text ("x,y,z,label\n", std::ios::ate);
    // 10 rows of 20 points at one height.
    const auto addRows = [&text] (int first_row, double height, int label) {
      for (int i = 0; i < 200; ++i)
        text << 0.25 * (i % 20) << ',' << 0.25 * (first_row + i / 20) << ',' << height
             << ',' << label << '\n';
    };
    addRows (0, 0.0, near);
    addRows (10, 0.0, far);
    addRows (0, 6.0, roof);
    for (int i = 0; i < 50; ++i)
      text << "-1,-1," << 0.02 * i << ',' << (i < 5 ? foot : hedge) << '\n';
    return text.str();
  }

  /** A floor with this line, without a line break, in place of its first point. */
  static std::string
  withFirstPoint (const std::string& line, const std::string& floor)
  {
    const std::size_t end_of_first = floor.find ("\n0.02,");
    return "x,y,z,label\n" + line + floor.substr (end_of_first);
  }

  /** The floor of one plane with this line in place of each of its first five points.
   */
  static std::string
  withFirstFivePoints (const std::string& line)
  {
    const std::string floor = floorOfOnePlane();
    const std::size_t begin_of_sixth = floor.find ("0.1,0,");
    std::string text = "x,y,z,label\n";
    for (int i = 0; i < 5; ++i)
      text += line;
    return text + floor.substr (begin_of_sixth);
  }

  /** 40 clouds of a plane of 40 x 40 points, 2 cm apart, seen from 1 m above, and the
   * poses of their sensors. The noise has a standard deviation of 1 cm, and is equal
   * for all points of a block of 4 x 4. In every second cloud the sensor is turned by
   * 90 degrees about z. */
  void
  writeNoisyClouds () const
  {
    fs::create_directory (folder_ / "noisy");
    pcl_ops::apps::Random random (1);
    std::string poses;
    constexpr int first = 100; // all names have three digits, so they sort by number
    for (int cloud = first; cloud < first + 40; ++cloud) {
      const bool is_turned = cloud % 2 == 1;
      std::array<double, 10 * 10> error_of_block{}; // [m]
      for (double& error : error_of_block)
        error = 0.01 * random.gaussian();
      std::ostringstream text ("x,y,z,label\n", std::ios::ate);
      for (int i = 0; i < 1600; ++i) {
        const int column = i % 40, row = i / 40;
        const double x = 0.02 * column, y = 0.02 * row;
        text << (is_turned ? y : x) << ',' << (is_turned ? -x : y) << ','
             << error_of_block[column / 4 + row / 4 * 10] - 1.0 << ",1\n";
      }
      folder_.write ("noisy/" + std::to_string (cloud) + ".xyz", text.str());
      poses += is_turned ? "0 0 0 1 0 0 0.70710678 0.70710678\n" : "0 0 0 1 0 0 0 1\n";
    }
    folder_.write ("poses.txt", poses);
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          EvaluateProgram,
                          testing::ValuesIn (answersIn (PCL_OPS_ANSWERS)),
                          nameOfAnswers);

TEST_P (EvaluateProgram, IsAsTheTableSays) { expectAnswers(); }

/** A change of the second plane of a.json that makes it wrong. */
struct WrongValue {
  std::string test_name;
  std::string key;
  /** Its new value; null: the key is removed. */
  Json value;
  /** What pcl_ops_evaluate says behind "planes[1].". */
  std::string complaint;

  friend std::ostream&
  operator<< (std::ostream& stream, const WrongValue& wrong)
  {
    return stream << wrong.key << ": " << wrong.value;
  }
};

/** Two lists of planes, one of which has a wrong value. */
class ListOfPlanes : public ProgramFolder,
                     public testing::WithParamInterface<WrongValue> {
protected:
  ListOfPlanes() : ProgramFolder (PCL_OPS_EVALUATE_PROGRAM) {}
};

// Numbers are too large above 1e40 (max_number in planes_command.cpp).
INSTANTIATE_TEST_SUITE_P (
    RefusedFor,
    ListOfPlanes,
    testing::Values (
        WrongValue{"NoId", "id", nullptr, "id is missing"},
        WrongValue{"NoOrientation", "orientation", nullptr, "orientation is missing"},
        WrongValue{"NoPoints", "points", nullptr, "points is missing"},
        WrongValue{"NoCentroid", "centroid", nullptr, "centroid is missing"},
        WrongValue{"NoRms", "rms", nullptr, "rms is missing"},
        WrongValue{
            "NoCoefficients", "coefficients", nullptr, "coefficients is missing"},
        WrongValue{"NegativeId", "id", -1, "id is no whole number from 0"},
        WrongValue{"ZeroPoints", "points", 0, "points is too small"},
        WrongValue{"HugePoints", "points", 1e200, "points is too large"},
        WrongValue{"MorePointsThanAreCounted", "points", 1e20, "points is too large"},
        WrongValue{"TextAsRms", "rms", "x", "rms is no number"},
        WrongValue{"HugeRms", "rms", 1e200, "rms is too large"},
        WrongValue{"TwoCoordinates", "centroid", {1, 2}, "centroid has not 3 numbers"},
        WrongValue{"TextAsZ", "centroid", {1, 2, "x"}, "centroid[2] is no number"},
        WrongValue{"HugeX", "centroid", {1e308, 0, 0}, "centroid[0] is too large"},
        WrongValue{"NoNormal",
                   "coefficients",
                   {0, 0, 0, 1},
                   "coefficients has the normal 0 0 0"},
        WrongValue{"HugeNormal",
                   "coefficients",
                   {1e308, 1e308, 1e308, 1},
                   "coefficients[0] is too large"},
        WrongValue{"UnknownOrientation",
                   "orientation",
                   "steep",
                   "orientation is not horizontal, vertical or other"},
        WrongValue{
            "NumberAsCorner", "hull", {Json{1, 2, 3}, Json (4)}, "hull[1] is no list"},
        WrongValue{"HugeCorner",
                   "hull",
                   {{0, 0, 0}, {1, 0, 0}, {1, -1e200, 0}},
                   "hull[2][1] is too large"}),
    [] (const auto& info) { return info.param.test_name; });

TEST_P (ListOfPlanes, NamesTheWrongValue)
{
  const std::string right = contentOf (PCL_OPS_INPUTS "/a.json");
  Json list = Json::parse (right);
  Json& plane = list.at ("planes").at (1);
  const WrongValue& wrong = GetParam();
  if (wrong.value.is_null())
    plane.erase (wrong.key);
  else
    plane[wrong.key] = wrong.value;
  folder_.write ("a.json", right);
  folder_.write ("bad.json", list.dump());
  const Outcome done = shell ("pcl_ops_evaluate planes a.json bad.json");
  EXPECT_EQ (done.exit_code, 1);
  const std::string complaint =
      "pcl_ops_evaluate: bad.json: planes[1]." + wrong.complaint;
  EXPECT_EQ (done.err.substr (0, complaint.size()), complaint);
  EXPECT_EQ (lines (done.err), 1u);
}

} // namespace
