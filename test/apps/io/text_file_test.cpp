// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <io/cloud_file.h>
#include <io/shifted_cloud.h>
#include <support/cloud_values.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

using namespace pcl_ops::apps;

namespace {

std::vector<std::string>
fieldsOf (const FileCloud& cloud)
{
  std::vector<std::string> names;
  for (const pcl::PCLPointField& field : cloud.points.fields)
    names.push_back (field.name);
  return names;
}

Eigen::Vector3d
placeOf (const FileCloud& cloud, std::size_t point)
{
  return CoordinateReader (cloud) (point);
}

using TextFile = CloudFolder;

} // namespace

TEST_F (TextFile, KeepsMillimetersOfUtmWhateverTheSeparator)
{
  const Eigen::Vector3d first (500000.123, 5400000.456, 120.789);
  const Eigen::Vector3d second (-500001.001, 5400000.457, -0.001);
  for (const std::string text :
       {"500000.123 5400000.456 120.789\n-500001.001 5400000.457 -0.001\n",
        "500000.123\t5400000.456\t120.789\n-500001.001\t5400000.457\t-0.001",
        "500000.123,5400000.456,120.789\r\n-500001.001,5400000.457,-0.001\r\n",
        "  500000.123 ; 5400000.456 ; 120.789\n\n\n-500001.001;5400000.457;-1e-3\n",
        "500000.123, 5400000.456,\t120.789 \n-500001.001, 5400000.457,\t-0.001\n"}) {
    SCOPED_TRACE (text);
    const FileCloud cloud = load ("in.xyz", text);
    ASSERT_EQ (cloud.size(), 2u);
    EXPECT_EQ (fieldsOf (cloud), (std::vector<std::string>{"x", "y", "z"}));
    EXPECT_EQ (placeOf (cloud, 0), first);
    EXPECT_EQ (placeOf (cloud, 1), second);
  }
}

TEST_F (TextFile, IsReadByEachOfItsExtensionsAndInFoldersByThoseOfClouds)
{
  for (const char* name : {"a.xyz", "a.txt", "a.pts", "a.csv", "a.XYZ"})
    EXPECT_EQ (load (name, "1 2 3\n").size(), 1u) << name;
  for (const char* name : {"a.xyz", "a.pts"})
    EXPECT_TRUE (isCloudFile (name)) << name;
  for (const char* name : {"README.txt", "planes.csv"})
    EXPECT_FALSE (isCloudFile (name)) << name;
}

TEST_F (TextFile, NamesItsFieldsAndFindsTheCoordinatesAmongThem)
{
  const std::pair<std::string, std::vector<std::string>> rows[] = {
      // As pandas, CloudCompare, and numpy's savetxt write it.
      {"x,y,z,intensity\n1,2,3,4\n", {"x", "y", "z", "intensity"}},
      {"\"X\",\"Y\",\"Z\",\"gps time\"\n1,2,3,4\n", {"x", "y", "z", "gps_time"}},
      {"//X Y Z R\n1 2 3 4\n", {"x", "y", "z", "R"}},
      {"# x y z i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"\xef\xbb\xbfX;Y;Z;I\n1;2;3;4\n", {"x", "y", "z", "I"}},
      {"East North Height Height\n1 2 3 4\n", {"x", "y", "z", "Height"}},
      {",z,y,x,i\n0,3,2,1,4\n", {"field_1", "z", "y", "x", "i"}},
      {"X [m],Y [m],Z [m],i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"X(m),Y(m),Z(m),i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"Easting,Northing,Elevation,i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"easting [m],northing [m],height [m],i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"E,N,H,i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"Points:0,Points:1,Points:2,i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      {"x,y,elevation,i\n1,2,3,4\n", {"x", "y", "z", "i"}},
      // Without names, and with some that no field can have.
      {"1 2 3 5 4\n", {"x", "y", "z", "field_4", "field_5"}},
      {"x,y,z,a,a,_,\n1,2,3,7,6,5,4\n",
       {"x", "y", "z", "a", "field_5", "field_6", "field_7"}},
      {"H,X [m],Z,Y,x,i\n7,6,3,2,1,4\n", {"H", "X_[m]", "z", "y", "x", "i"}}};
  for (const auto& [text, fields] : rows) {
    SCOPED_TRACE (text);
    const FileCloud cloud = load ("in.xyz", text);
    ASSERT_EQ (cloud.size(), 1u);
    EXPECT_EQ (fieldsOf (cloud), fields);
    EXPECT_EQ (placeOf (cloud, 0), Eigen::Vector3d (1, 2, 3));
    EXPECT_EQ (valuesOf<double> (cloud, fields.back())[0], 4.0);
  }
}

TEST_F (TextFile, LeavesCommentsEmptyLinesAndItsNumberOfPointsOut)
{
  for (const char* text : {"# a scan\n#\n// of today\n\n1 2 3\n \t\n# more\n4 5 6",
                           "2\n1 2 3 -100\n4 5 6 -99\n",
                           "//X Y Z\n2\n1 2 3\n4 5 6\n"}) {
    const FileCloud cloud = load ("in.xyz", text);
    ASSERT_EQ (cloud.size(), 2u) << text;
    EXPECT_EQ (placeOf (cloud, 1), Eigen::Vector3d (4, 5, 6)) << text;
  }
}

TEST_F (TextFile, HasPointsWithoutCoordinates)
{
  const FileCloud cloud = load ("in.xyz", "nan nan nan\n1 2 inf\n");
  ASSERT_EQ (cloud.size(), 2u);
  EXPECT_TRUE (std::isnan (placeOf (cloud, 0).x()));
  EXPECT_TRUE (std::isinf (placeOf (cloud, 1).z()));
  // pandas leaves out what is missing.
  const FileCloud missing = load ("in.xyz", "x,y,z,i\n,,,5\n1,2,3,\n");
  ASSERT_EQ (missing.size(), 2u);
  EXPECT_TRUE (std::isnan (placeOf (missing, 0).y()));
  EXPECT_TRUE (std::isnan (valuesOf<double> (missing, "i")[1]));
  EXPECT_EQ (placeOf (load ("in.xyz", "1e-999 -1e-999 +1e-999\n"), 0),
             Eigen::Vector3d (0, 0, 0));
}

TEST_F (TextFile, IsRefusedAsWhatItIsNot)
{
  EXPECT_TRUE (contains (complaintAbout ("in.xyz", "\xff\xfe\x31"), "UTF-16"));
  std::filesystem::create_directory (folder_ / "folder.csv");
  EXPECT_THROW (loadCloud (folder_ / "folder.csv"), WorkError);
  const std::string wide = "1" + std::string (2000, ',') + "\n";
  EXPECT_TRUE (contains (complaintAbout ("in.xyz", wide), "more than 1000 numbers"));
}

TEST_F (TextFile, ThatCannotBeReadSaysSo)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may read everything";
  const std::string file = folder_.write ("in.xyz", "1 2 3\n");
  std::filesystem::permissions (file, std::filesystem::perms::none);
  EXPECT_THROW (loadCloud (file), WorkError);
}

TEST_F (TextFile, TakesNoMoreMemoryThanItHasPointsFor)
{
  // A million empty lines are no million points.
  std::string text = "1 2 3\n" + std::string (1000000, '\n');
  EXPECT_LT (load ("in.xyz", text).points.data.capacity(), 10u * text.size());
  text = "1 2 3\n4 5 6\n" + std::string (1000000, '#');
  EXPECT_LT (load ("in.xyz", text).points.data.capacity(), 10u * text.size());
}
