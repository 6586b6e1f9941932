// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <page/page.h>
#include <support/temporary_folder.h>
#include <support/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl_ops::apps;
using Eigen::Vector3d;

namespace {

/** \brief Points, and for each the number of its plane, from 1 on, or 0 for no plane.
 */
struct LabeledPoints {
  std::vector<Vector3d> points;
  std::vector<std::uint32_t> labels;

  /** \brief Adds points along x from 0 on, 1 cm apart, at y [m]. Their z is between
   * -0.1 m and 0.1 m. */
  void
  addRow (std::uint32_t label, int point_count, double y)
  {
    for (int i = 0; i < point_count; ++i) {
      points.emplace_back (0.01 * i, y, 0.1 * std::sin (i));
      labels.push_back (label);
    }
  }

  /** \brief A group for each plane, then one for no plane. */
  std::vector<PointGroup>
  groups (std::size_t plane_count, std::size_t max_points = max_points_on_page) const
  {
    return groupPoints (
        labels, plane_count, [this] (std::size_t i) { return points[i]; }, max_points);
  }
};

/** \brief The text of the script element of a page with this id. */
std::string
elementOf (const std::string& page, const std::string& id)
{
  const std::size_t tag = page.find ("id=\"" + id + "\"");
  const std::size_t begin = page.find ('>', tag) + 1;
  return page.substr (begin, page.find ("</script>", begin) - begin);
}

/** \brief The bytes that a text encodes in base64, without padding: four letters are
 * three bytes. */
std::vector<std::uint8_t>
decoded (const std::string& letters)
{
  const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    bits = bits << 6U | static_cast<std::uint32_t> (digits.find (letters[i]));
    if (i % 4 == 3)
      for (const unsigned shift : {16U, 8U, 0U})
        bytes.push_back (bits >> shift & 255U);
  }
  return bytes;
}

/** \brief The points of a group as a browser shows them. */
struct ShownGroup {
  std::size_t all; // number of its finite points; some may not be on the page
  Vector3d step;   // length of a step of the coordinates along each axis [m]
  std::vector<Vector3d> points;
};

Vector3d
vectorIn (const nlohmann::json& list)
{
  return Vector3d (list.at (0), list.at (1), list.at (2));
}

/** \brief The groups of points in the data of a page. */
std::vector<ShownGroup>
groupsOn (const std::string& page)
{
  const std::vector<std::uint8_t> bytes = decoded (elementOf (page, "steps"));
  std::size_t offset = 0;
  const auto nextCoordinate = [&] { // of 16 bits, the low byte first
    const int number = bytes.at (offset) + 256 * bytes.at (offset + 1);
    offset += 2;
    return double (number);
  };
  std::vector<ShownGroup> groups;
  for (const nlohmann::json& json :
       nlohmann::json::parse (elementOf (page, "groups"))) {
    const Vector3d origin = vectorIn (json.at ("origin"));
    ShownGroup& group = groups.emplace_back (
        ShownGroup{json.at ("all"), vectorIn (json.at ("step")), {}});
    for (std::size_t i = 0; i < json.at ("shown"); ++i) {
      const double x = nextCoordinate(), y = nextCoordinate(), z = nextCoordinate();
      group.points.emplace_back (origin + group.step.cwiseProduct (Vector3d (x, y, z)));
    }
  }
  EXPECT_EQ (offset, bytes.size());
  return groups;
}

class Page : public testing::Test {
protected:
  /** \brief The text of a page with these groups. */
  std::string
  pageOf (const std::vector<PointGroup>& groups,
          const std::string& description = "{}",
          const Vector3d& shift = Vector3d::Zero()) const
  {
    savePage (folder_ / "page.html", description, groups, shift);
    return contentOf (folder_ / "page.html");
  }

  TemporaryFolder folder_;
};

TEST_F (Page, HasEachPointInItsGroupWithinHalfAStep)
{
  LabeledPoints cloud;
  cloud.addRow (2, 300, 1.0);
  cloud.addRow (0, 50, 7.0);
  cloud.addRow (1, 200, 3.0);
  const Vector3d shift (500'000, 5'400'000, 100); // as of UTM
  const std::vector<ShownGroup> shown =
      groupsOn (pageOf (cloud.groups (2), "{}", shift));
  ASSERT_EQ (shown.size(), 3u);
  // Label 0, for no plane, has the last group.
  const std::vector<std::uint32_t> group_of_label = {2, 0, 1};
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const ShownGroup& group = shown[group_of_label[cloud.labels[i]]];
    const double rounding = 1e-8; // of sums with the shift [m]
    const Vector3d max_distance = 0.5 * group.step + Vector3d::Constant (rounding);
    EXPECT_TRUE (
        std::any_of (group.points.begin(),
                     group.points.end(),
                     [&] (auto& point) {
                       const Vector3d difference = point - shift - cloud.points[i];
                       return (difference.array().abs() <= max_distance.array()).all();
                     }))
        << i;
  }
  EXPECT_EQ (shown[0].points.size(), 200u);
  EXPECT_EQ (shown[1].points.size(), 300u);
  EXPECT_EQ (shown[2].points.size(), 50u);
  // The row of plane 2 is 3 m long; 16 bits make 65535 steps of it.
  EXPECT_LE (shown[1].step.maxCoeff(), 3.0 / 65535 + 1e-12);
}

TEST_F (Page, OfManyPointsHasSomeOfEachPlaneAndAtMostTheLimit)
{
  LabeledPoints cloud;
  cloud.addRow (1, 100'000, 1.0);
  cloud.addRow (2, 10'000, 2.0);
  cloud.addRow (3, 10, 3.0);
  cloud.addRow (0, 20'000, 4.0);
  const std::vector<ShownGroup> shown = groupsOn (pageOf (cloud.groups (3, 1000)));
  std::size_t points_on_page = 0;
  for (const ShownGroup& group : shown)
    points_on_page += group.points.size();
  EXPECT_LE (points_on_page, 1000u);
  EXPECT_GE (points_on_page, 600u) << "most of the limit is used";
  EXPECT_EQ (shown[0].all, 100'000u);
  EXPECT_GT (shown[0].points.size(), 300u) << "the largest plane has most";
  EXPECT_GE (shown[1].points.size(), 100u) << "a plane shows a hundred if it has them";
  EXPECT_EQ (shown[2].points.size(), 10u);
}

TEST_F (Page, ShowsAnEvenSampleWhoseFirstQuarterIsEvenToo)
{
  // Four standard deviations of the share of 1000 random points that one half has.
  const double tolerance = 0.06;
  LabeledPoints cloud;
  cloud.addRow (1, 100'000, 1.0);
  const std::vector<Vector3d> points =
      groupsOn (pageOf (cloud.groups (1, 4000)))[0].points;
  const auto isInFirstHalf = [] (const Vector3d& point) {
    constexpr double half_length = 500.0; // of the row [m]
    return point.x() < half_length;
  };
  for (const std::size_t point_count : {points.size(), points.size() / 4}) {
    const auto end = points.begin() + static_cast<std::ptrdiff_t> (point_count);
    const auto in_first_half =
        double (std::count_if (points.begin(), end, isInFirstHalf));
    EXPECT_NEAR (in_first_half / double (point_count), 0.5, tolerance);
  }
}

TEST_F (Page, IsTheSameForAnyOrderOfThePoints)
{
  LabeledPoints cloud;
  cloud.addRow (1, 3000, 1.0);
  cloud.addRow (0, 3000, 2.0);
  const std::string before = pageOf (cloud.groups (1, 1000));
  ASSERT_FALSE (groupsOn (before).at (0).points.empty());
  std::reverse (cloud.points.begin(), cloud.points.end());
  std::reverse (cloud.labels.begin(), cloud.labels.end());
  EXPECT_EQ (pageOf (cloud.groups (1, 1000)), before);
}

TEST_F (Page, LeavesOutPointsWithoutCoordinates)
{
  LabeledPoints cloud;
  cloud.addRow (1, 5, 1.0);
  cloud.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  cloud.points[3].z() = std::numeric_limits<double>::infinity();
  const std::vector<ShownGroup> shown = groupsOn (pageOf (cloud.groups (1)));
  EXPECT_EQ (shown[0].points.size(), 3u);
  EXPECT_EQ (shown[0].all, 3u);
}

TEST_F (Page, OfNoPointsHasEmptyGroups)
{
  const std::vector<ShownGroup> shown = groupsOn (pageOf (LabeledPoints().groups (2)));
  ASSERT_EQ (shown.size(), 3u);
  for (const ShownGroup& group : shown)
    EXPECT_TRUE (group.points.empty());
}

TEST_F (Page, HasAtMostEightBytesForAPointAnd17MBForTheMostPoints)
{
  LabeledPoints cloud;
  cloud.addRow (1, 30'000, 1.0);
  const std::size_t empty_page = pageOf (LabeledPoints().groups (1)).size();
  ASSERT_GT (empty_page, 0u);
  EXPECT_GT (pageOf (cloud.groups (1)).size(), empty_page + 7 * 30'000);
  constexpr std::size_t max_size_of_point = 8; // [byte]
  const std::size_t numbers_of_group = 200;    // its origin, step and count [byte]
  EXPECT_LT (pageOf (cloud.groups (1)).size() - empty_page,
             max_size_of_point * 30'000 + numbers_of_group);
  EXPECT_LT (empty_page + max_size_of_point * max_points_on_page, 17'000'000u);
}

TEST_F (Page, KeepsATitleThatLooksLikeTheEndOfAScript)
{
  const nlohmann::json description = {{"title", "</script><script>alert (1)<!--"}};
  const std::string plain = pageOf (LabeledPoints().groups (0));
  const std::string page = pageOf (LabeledPoints().groups (0), description.dump());
  EXPECT_EQ (nlohmann::json::parse (elementOf (page, "description")), description);
  const auto countScripts = [] (const std::string& text) {
    std::size_t count = 0;
    std::size_t offset = text.find ("<script");
    for (; offset != std::string::npos; offset = text.find ("<script", offset + 1))
      ++count;
    return count;
  };
  EXPECT_EQ (countScripts (page), countScripts (plain));
}

TEST_F (Page, LoadsNothing)
{
  const std::string page = pageOf (LabeledPoints().groups (0));
  ASSERT_EQ (groupsOn (page).size(), 1u);
  // {{ would be left of a placeholder of the template.
  for (const char* word : {"http", "src=", "import", "fetch", "url(", "{{"})
    EXPECT_EQ (page.find (word), std::string::npos) << word;
}

} // namespace
