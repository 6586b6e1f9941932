// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/detectors/own_labels.h>
#include <support/temporary_folder.h>
#include <support/text.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_ops::evaluation;

/** A cloud of three points, and a folder with its label files. */
class OwnLabelsTest : public testing::Test {
protected:
  TemporaryFolder folder;
  XyzCloud::Ptr cloud{new XyzCloud (3, 1)};
  RunSettings settings;

  OwnLabelsTest()
  {
    settings.data_set = "rooms";
    settings.cloud_name = "room-0001";
  }

  DetectorRun
  run () const
  {
    return ownLabels ("mine=" + folder.path()).run (cloud, settings);
  }

  PlaneLabels
  labels () const
  {
    return run().labels;
  }

  /** Returns what the error message for a file with this text says after its name. */
  std::string
  complaintAbout (const std::string& name, const std::string& text) const
  {
    const std::string file = folder.write (name, text);
    const std::string complaint = complaintOf ([&] { run(); });
    return complaint.substr (std::min (complaint.size(), file.size() + 2));
  }
};

template <typename Number>
std::string
npyOf (const std::string& type,
       const std::string& shape,
       const std::vector<Number>& numbers)
{
  const std::string header =
      "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  return "\x93NUMPY\1" + std::string (1, '\0') + std::string (1, char (header.size())) +
         std::string (1, '\0') + header +
         std::string (reinterpret_cast<const char*> (numbers.data()),
                      numbers.size() * sizeof (Number));
}

using Integers = std::vector<std::int64_t>;

TEST_F (OwnLabelsTest, AreALineEachInATextAsNumPySavesIt)
{
  folder.write ("room-0001.txt", "# labels\n1.000e+00\n0\n\n2\r\n");
  EXPECT_EQ (labels(), (PlaneLabels{1, 0, 2}));
}

TEST_F (OwnLabelsTest, AreAnArrayOfAnyTypeOfNumbers)
{
  const PlaneLabels expected = {1, 0, 2};
  folder.write ("room-0001.npy", npyOf ("<i8", "(3,)", Integers{1, 0, 2}));
  EXPECT_EQ (labels(), expected);
  folder.write ("room-0001.npy",
                npyOf ("|u1", "(3, 1)", std::vector<std::uint8_t>{1, 0, 2}));
  EXPECT_EQ (labels(), expected);
  folder.write ("room-0001.npy",
                npyOf ("<f4", "(1, 3)", std::vector<float>{1.0f, 0.0f, 2.0f}));
  EXPECT_EQ (labels(), expected);
}

TEST_F (OwnLabelsTest, AreTheFieldLabelOfAPcdWhateverItsSign)
{
  folder.write ("room-0001.pcd",
                "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F I\n"
                "COUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
                "POINTS 3\nDATA ascii\n0 0 0 0\n0 0 0 -1\n0 0 0 5\n");
  EXPECT_EQ (labels(), (PlaneLabels{1, 0, 2}));
}

TEST_F (OwnLabelsTest, BelowZeroAreNoPlaneAndThenZeroIsAPlane)
{
  folder.write ("room-0001.txt", "0\n-1\n1\n");
  EXPECT_EQ (labels(), (PlaneLabels{1, 0, 2}));
  folder.write ("room-0001.txt", "0\n1\n1\n");
  EXPECT_EQ (labels(), (PlaneLabels{0, 1, 1}));
}

TEST_F (OwnLabelsTest, CountPlanesButNoTime)
{
  folder.write ("room-0001.txt", "7\n0\n3000000000\n");
  EXPECT_EQ (run().planes_before_merging, 2u);
  EXPECT_EQ (labels(), (PlaneLabels{1, 0, 2}));
  EXPECT_TRUE (std::isnan (run().durations.detection));
  EXPECT_TRUE (std::isnan (run().durations.merging));
}

TEST_F (OwnLabelsTest, OfTheDataSetComeBeforeThoseOfTheNameAlone)
{
  folder.write ("room-0001.txt", "0\n0\n0\n");
  std::filesystem::create_directory (folder / "rooms");
  folder.write ("rooms/room-0001.txt", "1\n1\n1\n");
  EXPECT_EQ (labels(), (PlaneLabels{1, 1, 1}));
}

TEST_F (OwnLabelsTest, OfAFileAreFoundWithAndWithoutItsExtension)
{
  settings.cloud_name = "room.v2.pcd";
  folder.write ("room.v2.txt", "0\n1\n0\n");
  EXPECT_EQ (labels(), (PlaneLabels{0, 1, 0}));
  folder.write ("room.v2.pcd.txt", "1\n1\n1\n");
  EXPECT_EQ (labels(), (PlaneLabels{1, 1, 1}));
}

TEST_F (OwnLabelsTest, OfAnImageMayBeThoseOfAllItsPixels)
{
  const XyzCloud::Ptr image (new XyzCloud (2, 2));
  (*image)[1].x = std::numeric_limits<float>::quiet_NaN();
  settings.image = image;
  folder.write ("room-0001.txt", "1\n2\n3\n3\n");
  EXPECT_EQ (labels(), (PlaneLabels{1, 3, 3}));
}

TEST_F (OwnLabelsTest, ThatAreMissingAreReportedWithBothPlaces)
{
  EXPECT_EQ (complaintOf ([&] { run(); }),
             folder.path() +
                 ": has neither rooms/room-0001.npy nor room-0001.npy, nor such a .txt "
                 "or .pcd; save the labels");
}

TEST_F (OwnLabelsTest, OfAnotherNumberOfPointsAreRefusedWithBothNumbers)
{
  EXPECT_EQ (complaintAbout ("room-0001.txt", "1\n1\n"),
             "has 2 labels, the cloud 3 finite points; give one for each, in the order "
             "of truth.pcd");
}

TEST_F (OwnLabelsTest, ThatAreNoWholeNumbersOrLostTheirSignAreRefused)
{
  for (const char* label : {"0.5", "nan", "4294967295", "-1e300"})
    EXPECT_TRUE (contains (
        complaintAbout ("room-0001.txt", "1\n" + std::string (label) + "\n1\n"),
        "point 1 has the label "));
  EXPECT_TRUE (contains (complaintAbout ("room-0001.txt", "1\n1 2 3\n"),
                         "is damaged: line 2 has 3 numbers instead of 1"));
  EXPECT_TRUE (contains (complaintAbout ("room-0001.txt", "1\nwall\n"),
                         "is damaged: line 2 has 'wall', which is no number"));
}

TEST_F (OwnLabelsTest, OfArraysOfOtherShapesOrSizesAreRefused)
{
  const auto complaint = [&] (const std::string& shape, const Integers& numbers) {
    return complaintAbout ("room-0001.npy", npyOf ("<i8", shape, numbers));
  };
  for (const char* shape : {"()", "(2, 2)", "(1, 1, 4)"})
    EXPECT_EQ (complaint (shape, {1, 1, 1, 1}),
               "has an array of another shape than (N,); save a number for each point")
        << shape;
  EXPECT_TRUE (contains (complaint ("(4,)", {1, 1, 1}), "is truncated"));
  EXPECT_TRUE (contains (complaint ("(2,)", {1, 1, 1}), "more numbers than its shape"));
  for (const char* shape : {"(0,)", "(0, 1)", "(1, 0)"})
    EXPECT_TRUE (contains (complaint (shape, {}), "has 0 labels, the cloud 3"))
        << shape;
}

} // namespace
