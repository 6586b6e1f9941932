// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/io.h>

#include "segment_program.h"
#include <io/cloud_file.h>
#include <support/cloud_values.h>

#include <sstream>

using pcl_ops::apps::FileCloud;
using pcl_ops::apps::loadCloud;

namespace {

class SegmentPly : public Segment {
protected:
  /** \brief Labels a cloud as .pcd and as .ply. */
  void
  writeBoth (const std::string& input) const
  {
    for (const char* output : {" out.pcd", " out.ply"}) {
      expectDone (input + output);
    }
  }

  /** \brief Whether the .ply is read with these fields of the .pcd, to the bit. */
  void
  expectSameFields (const std::vector<std::string>& names) const
  {
    const FileCloud pcd = loadCloud (folder_ / "out.pcd");
    const FileCloud ply = loadCloud (folder_ / "out.ply");
    ASSERT_EQ (ply.points.width, pcd.points.width);
    ASSERT_EQ (ply.points.height, pcd.points.height);
    for (const std::string& name : names) {
      EXPECT_EQ (fieldOf (ply, name).datatype, fieldOf (pcd, name).datatype) << name;
      EXPECT_TRUE (bytesOf (ply, name) == bytesOf (pcd, name)) << name;
    }
  }

  static std::vector<std::uint8_t>
  bytesOf (const FileCloud& cloud, const std::string& name)
  {
    const pcl::PCLPointField field = fieldOf (cloud, name);
    const int size = pcl::getFieldSize (field.datatype);
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto number = cloud.points.data.begin() +
                          std::ptrdiff_t (i * cloud.points.point_step + field.offset);
      bytes.insert (bytes.end(), number, number + size);
    }
    return bytes;
  }
};

} // namespace

TEST_F (SegmentPly, HasEveryFieldOfTheInputToTheBit)
{
  writeBoth ("in.pcd");
  expectSameFields ({"x", "y", "z", "intensity", "label"});
  const FileCloud ply = loadCloud (folder_ / "out.ply");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"),
                         "ply\nformat binary_little_endian 1.0\n"));
  // PCL's reader leaves the fourth byte of a colour as it is.
  const FileCloud pcd = loadCloud (folder_ / "out.pcd");
  const auto read = bytesOf (ply, "rgb"), written = bytesOf (pcd, "rgb");
  ASSERT_EQ (read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    if (i % 4 != 3) {
      ASSERT_EQ (read[i], written[i]) << i;
    }
}

TEST_F (SegmentPly, KeepsFieldsWithTheNamesOfItsColors)
{
  std::ostringstream text;
  text << "x,y,z,red,nx,normal_x\n";
  for (int i = 0; i < 2000; ++i)
    text << 0.05 * (i % 50) << "," << 0.05 * (i / 50) << ",0," << i << ",2,3\n";
  folder_.write ("in.csv", text.str());
  expectDone ("in.csv out.ply");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"), "property uchar red\n"));
  const FileCloud in = loadCloud (folder_ / "in.csv");
  const FileCloud ply = loadCloud (folder_ / "out.ply");
  EXPECT_TRUE (bytesOf (ply, "red_") == bytesOf (in, "red"));
  EXPECT_TRUE (bytesOf (ply, "nx_") == bytesOf (in, "normal_x"));
}

TEST_F (SegmentPly, HasTheFieldsOtherProgramsLookFor)
{
  std::string points;
  for (int i = 0; i < 4; ++i)
    points += std::to_string (i) + " 0 1.5 0 0 1 7 8 4294967297 9\n";
  folder_.write ("odd.pcd",
                 "FIELDS x y z normal_x normal_y normal_z shape stamp red\n"
                 "SIZE 4 8 4 4 4 4 2 8 4\nTYPE F F F F F F I I F\n"
                 "COUNT 1 1 1 1 1 1 2 1 1\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n" +
                     points);
  expectDone ("odd.pcd out.ply");
  const std::string ply = contentOf (folder_ / "out.ply");
  EXPECT_EQ (ply.substr (0, ply.find ("end_header")),
             "ply\nformat binary_little_endian 1.0\nobj_info num_cols 2\n"
             "obj_info num_rows 2\nelement vertex 4\nproperty float x\n"
             "property double y\nproperty float z\nproperty float nx\n"
             "property float ny\nproperty float nz\nproperty short shape_0\n"
             "property short shape_1\nproperty double stamp\nproperty float red_\n"
             "property uint label\nproperty uchar red\nproperty uchar green\nproperty "
             "uchar blue\n");
  const FileCloud read = loadCloud (folder_ / "out.ply");
  EXPECT_EQ (read.points.width, 2u);
  EXPECT_EQ (valuesOf<double> (read, "stamp")[0], 4294967297.0);
}
