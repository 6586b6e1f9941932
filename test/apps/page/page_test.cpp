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

/** \brief Points, and for each the number of its plane, from 1 on, or 0 for none. */
struct LabeledPoints {
  std::vector<Vector3d> points;
  std::vector<std::uint32_t> labels;

  /** \brief Adds points along x from 0 on, 1 cm apart. Their z varies by 0.1 m. */
  void
  addRow (std::uint32_t label, int number, double y)
  {
    for (int i = 0; i < number; ++i) {
      points.emplace_back (0.01 * i, y, 0.1 * std::sin (i));
      labels.push_back (label);
    }
  }

  std::vector<PointGroup>
  groups (std::size_t planes, std::size_t max_points = max_points_on_page) const
  {
    return groupPoints (
        labels, planes, [this] (std::size_t i) { return points[i]; }, max_points);
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
  Vector3d step;   // between positions that a point can have, along each axis [m]
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
  std::size_t next = 0;
  const auto coordinate = [&] { // the next one, of 16 bits, low byte first
    const int number = bytes.at (next) + 256 * bytes.at (next + 1);
    next += 2;
    return double (number);
  };
  std::vector<ShownGroup> groups;
  for (const nlohmann::json& one : nlohmann::json::parse (elementOf (page, "groups"))) {
    const Vector3d origin = vectorIn (one.at ("origin"));
    ShownGroup& group = groups.emplace_back (
        ShownGroup{one.at ("all"), vectorIn (one.at ("step")), {}});
    for (std::size_t i = 0; i < one.at ("shown"); ++i) {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      group.points.emplace_back (origin + group.step.cwiseProduct (Vector3d (x, y, z)));
    }
  }
  EXPECT_EQ (next, bytes.size());
  return groups;
}

class Page : public testing::Test {
protected:
  /** \brief The page of some groups. */
  std::string
  textOf (const std::vector<PointGroup>& groups,
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
      groupsOn (textOf (cloud.groups (2), "{}", shift));
  ASSERT_EQ (shown.size(), 3u);
  // Planes have a group each, and the points on none are the last one.
  const std::vector<std::uint32_t> group_of_label = {2, 0, 1};
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const ShownGroup& group = shown[group_of_label[cloud.labels[i]]];
    const double rounding = 1e-8; // of sums with the shift [m]
    const Vector3d half_step = 0.5 * group.step + Vector3d::Constant (rounding);
    EXPECT_TRUE (std::any_of (group.points.begin(), group.points.end(), [&] (auto& p) {
      return ((p - shift - cloud.points[i]).array().abs() <= half_step.array()).all();
    })) << i;
  }
  EXPECT_EQ (shown[0].points.size(), 200u);
  EXPECT_EQ (shown[1].points.size(), 300u);
  EXPECT_EQ (shown[2].points.size(), 50u);
  EXPECT_LE (shown[1].step.maxCoeff(), 3.0 / 65535 + 1e-12) << "3 m, 16 bits";
}

TEST_F (Page, OfManyPointsHasSomeOfEachPlaneAndAtMostTheLimit)
{
  LabeledPoints cloud;
  cloud.addRow (1, 100'000, 1.0);
  cloud.addRow (2, 10'000, 2.0);
  cloud.addRow (3, 10, 3.0);
  cloud.addRow (0, 20'000, 4.0);
  const std::vector<ShownGroup> shown = groupsOn (textOf (cloud.groups (3, 1000)));
  std::size_t all = 0;
  for (const ShownGroup& group : shown)
    all += group.points.size();
  EXPECT_LE (all, 1000u);
  EXPECT_GE (all, 600u) << "most of the limit is used";
  EXPECT_EQ (shown[0].all, 100'000u);
  EXPECT_GT (shown[0].points.size(), 300u) << "the largest plane has most";
  EXPECT_GE (shown[1].points.size(), 100u) << "each has a hundred, if it has as many";
  EXPECT_EQ (shown[2].points.size(), 10u);
}

TEST_F (Page, ShowsAnEvenSampleWhoseFirstQuarterIsEvenToo)
{
  // Four standard deviations of the share of 1000 random points that are left.
  const double tolerance = 0.06;
  LabeledPoints cloud;
  cloud.addRow (1, 100'000, 1.0);
  const std::vector<Vector3d> points =
      groupsOn (textOf (cloud.groups (1, 4000)))[0].points;
  for (const std::size_t part : {points.size(), points.size() / 4}) {
    // The row is 1000 m long.
    const auto is_left = [] (const Vector3d& point) { return point.x() < 500.0; };
    const auto end = points.begin() + static_cast<std::ptrdiff_t> (part);
    const auto left = double (std::count_if (points.begin(), end, is_left));
    EXPECT_NEAR (left / double (part), 0.5, tolerance);
  }
}

TEST_F (Page, IsTheSameForAnyOrderOfThePoints)
{
  LabeledPoints cloud;
  cloud.addRow (1, 3000, 1.0);
  cloud.addRow (0, 3000, 2.0);
  const std::string before = textOf (cloud.groups (1, 1000));
  std::reverse (cloud.points.begin(), cloud.points.end());
  std::reverse (cloud.labels.begin(), cloud.labels.end());
  EXPECT_EQ (textOf (cloud.groups (1, 1000)), before);
}

TEST_F (Page, LeavesOutPointsWithoutCoordinates)
{
  LabeledPoints cloud;
  cloud.addRow (1, 5, 1.0);
  cloud.points[2].y() = std::numeric_limits<double>::quiet_NaN();
  cloud.points[3].z() = std::numeric_limits<double>::infinity();
  const std::vector<ShownGroup> shown = groupsOn (textOf (cloud.groups (1)));
  EXPECT_EQ (shown[0].points.size(), 3u);
  EXPECT_EQ (shown[0].all, 3u);
}

TEST_F (Page, OfNoPointsHasEmptyGroups)
{
  const std::vector<ShownGroup> shown = groupsOn (textOf (LabeledPoints().groups (2)));
  ASSERT_EQ (shown.size(), 3u);
  for (const ShownGroup& group : shown)
    EXPECT_TRUE (group.points.empty());
}

TEST_F (Page, HasAtMostEightBytesForAPointAnd17MBForTheMostPoints)
{
  LabeledPoints cloud;
  cloud.addRow (1, 30'000, 1.0);
  const std::size_t empty = textOf (LabeledPoints().groups (1)).size();
  const std::size_t numbers_of_group = 200; // its origin, step and count
  EXPECT_LT (textOf (cloud.groups (1)).size() - empty, 8u * 30'000 + numbers_of_group);
  EXPECT_LT (empty + 8u * max_points_on_page, 17'000'000u);
}

TEST_F (Page, KeepsNamesThatLookLikeTheEndOfAScript)
{
  const nlohmann::json description = {{"title", "</script><script>alert (1)<!--"}};
  const std::string plain = textOf (LabeledPoints().groups (0));
  const std::string page = textOf (LabeledPoints().groups (0), description.dump());
  EXPECT_EQ (nlohmann::json::parse (elementOf (page, "description")), description);
  const auto countScripts = [] (const std::string& text) {
    std::size_t number = 0;
    for (std::size_t at = 0; (at = text.find ("<script", at)) != std::string::npos;
         ++at)
      ++number;
    return number;
  };
  EXPECT_EQ (countScripts (page), countScripts (plain));
}

TEST_F (Page, NamesNothingToLoad)
{
  const std::string page = textOf (LabeledPoints().groups (0));
  for (const char* word : {"http", "src=", "import", "fetch", "url(", "{{"})
    EXPECT_EQ (page.find (word), std::string::npos) << word;
}

} // namespace
