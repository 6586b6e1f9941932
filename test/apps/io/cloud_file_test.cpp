// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include <io/cloud_fields.h>
#include <io/cloud_file.h>
#include <support/temporary_folder.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace pcl_ops::apps;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/** \brief Two readings and a missing one between them, with intensity. */
pcl::PointCloud<pcl::PointXYZI>
threePoints ()
{
  pcl::PointCloud<pcl::PointXYZI> cloud;
  cloud.push_back ({1.0f, 2.0f, 3.0f, 0.5f});
  cloud.push_back ({not_a_number, not_a_number, not_a_number, 0.25f});
  cloud.push_back ({4.0f, 5.0f, 6.0f, 0.75f});
  cloud.is_dense = false;
  cloud.sensor_origin_ = Eigen::Vector4f (0.5f, -1.0f, 1.5f, 0.0f);
  cloud.sensor_orientation_ = Eigen::Quaternionf (0.0f, 1.0f, 0.0f, 0.0f);
  return cloud;
}

std::string
asciiPcd (const std::string& header_change, const std::string& body = "1 2 3\n4 5 6\n")
{
  std::string pcd =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
      "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n";
  const std::string key = header_change.substr (0, header_change.find (' '));
  const std::size_t line = key.empty() ? pcd.size() : pcd.find (key);
  if (line < pcd.size())
    pcd.replace (line, pcd.find ('\n', line) - line, header_change);
  return pcd + body;
}

std::string
plyWith (const std::string& elements, const std::string& body)
{
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

const std::string two_vertices =
    "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";

/** \return what loading a file complains about, without the file's name */
std::string
complaintAbout (const std::string& file)
{
  try {
    loadCloud (file);
  }
  catch (const std::runtime_error& error) {
    const std::string text = error.what();
    return text.substr (text.find (file) == 0 ? file.size() + 2 : 0);
  }
  return "";
}

class CloudFile : public testing::Test {
protected:
  CloudFile() { pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); }

  TemporaryFolder folder_;
};

} // namespace

TEST_F (CloudFile, KeepsPointsFieldsAndPoseInEveryFormat)
{
  using Save = std::function<void (const std::string&)>;
  const pcl::PointCloud<pcl::PointXYZI> cloud = threePoints();
  const std::vector<std::pair<std::string, Save>> formats = {
      {"ascii.pcd", [&] (auto& file) { pcl::io::savePCDFileASCII (file, cloud); }},
      {"binary.pcd", [&] (auto& file) { pcl::io::savePCDFileBinary (file, cloud); }},
      {"compressed.pcd",
       [&] (auto& file) { pcl::io::savePCDFileBinaryCompressed (file, cloud); }},
      {"ascii.ply", [&] (auto& file) { pcl::io::savePLYFileASCII (file, cloud); }},
      {"binary.PLY", [&] (auto& file) { pcl::io::savePLYFileBinary (file, cloud); }}};
  for (const auto& [name, save] : formats) {
    SCOPED_TRACE (name);
    save (folder_ / name);
    const FileCloud loaded = loadCloud (folder_ / name);
    const ShiftedCloud shifted = shiftedCloudOf (loaded);
    ASSERT_EQ (shifted.cloud->size(), 3u);
    EXPECT_TRUE (std::isnan ((*shifted.cloud)[1].x));
    EXPECT_EQ ((*shifted.cloud)[2].getVector3fMap(), Eigen::Vector3f (4, 5, 6));
    EXPECT_TRUE (hasField (loaded, "intensity"));
    if (name.find (".pcd") == std::string::npos)
      continue; // the pose of a PLY is not read
    EXPECT_TRUE (loaded.origin.head<3>().isApprox (Eigen::Vector3f (0.5, -1, 1.5)));
    EXPECT_NEAR (std::abs (loaded.orientation.x()), 1.0, 1e-6);
  }
}

TEST_F (CloudFile, SavesWhatItLoadedAndNoByteMore)
{
  pcl::io::savePCDFileBinary (folder_ / "in.pcd", threePoints());
  savePcd (folder_ / "out.pcd", loadCloud (folder_ / "in.pcd"));
  EXPECT_TRUE (contentOf (folder_ / "in.pcd") == contentOf (folder_ / "out.pcd"));
}

TEST_F (CloudFile, AddsLabelsAndColorsBesideTheOtherFields)
{
  pcl::io::savePCDFileBinary (folder_ / "in.pcd", threePoints());
  FileCloud cloud = loadCloud (folder_ / "in.pcd");
  setLabels (cloud, {2, 0, 1});
  setColors (cloud, {{255, 0, 0}, {128, 128, 128}, {0, 0, 255}});
  savePcd (folder_ / "out.pcd", cloud);

  pcl::PointCloud<pcl::PointXYZRGBL> colored;
  pcl::PointCloud<pcl::PointXYZI> others;
  ASSERT_EQ (pcl::io::loadPCDFile (folder_ / "out.pcd", colored), 0);
  ASSERT_EQ (pcl::io::loadPCDFile (folder_ / "out.pcd", others), 0);
  EXPECT_EQ (colored[0].label, 2u);
  EXPECT_EQ (colored[0].r, 255);
  EXPECT_EQ (colored[2].label, 1u);
  EXPECT_EQ (colored[2].b, 255);
  EXPECT_EQ (others[1].intensity, 0.25f);
  EXPECT_EQ (others[2].y, 5.0f);
}

TEST_F (CloudFile, ReplacesLabelsAndColorsTheInputHad)
{
  const std::string file =
      folder_.write ("in.pcd",
                     "FIELDS x y label rgba z\nSIZE 4 4 1 4 4\nTYPE F F U U F\n"
                     "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 7 255 3\n");
  FileCloud cloud = loadCloud (file);
  setLabels (cloud, {70000});
  setColors (cloud, {{9, 8, 7}});
  pcl::PointCloud<pcl::PointXYZRGBL> colored;
  pcl::fromPCLPointCloud2 (cloud.points, colored);
  EXPECT_EQ (colored[0].label, 70000u);
  EXPECT_EQ (colored[0].r, 9);
  EXPECT_EQ (colored[0].z, 3.0f);
  EXPECT_TRUE (hasField (cloud, "rgba"));
  EXPECT_EQ (cloud.points.fields.size(), 6u);
}

TEST_F (CloudFile, KeepsMillimetresOfDoublePrecisionFarFromZero)
{
  const std::string file = folder_.write (
      "utm.ply",
      plyWith ("element vertex 2\nproperty double x\nproperty double y\n"
               "property double z\n",
               "512345.001 5412345.002 99.003\n512346.002 5412345.002 99.003\n"));
  const ShiftedCloud shifted = shiftedCloudOf (loadCloud (file));
  EXPECT_NEAR ((*shifted.cloud)[1].x - (*shifted.cloud)[0].x, 1.001, 1e-6);
  EXPECT_NEAR ((*shifted.cloud)[1].x + shifted.shift.x(), 512346.002, 1e-6);
}

TEST_F (CloudFile, KeepsMillimetresBesideAPointFarFromAllOthers)
{
  const std::string far = folder_.write (
      "far.ply",
      plyWith ("element vertex 5\nproperty double x\nproperty double y\n"
               "property double z\n",
               "1e8 1e8 0\n0 0 0\n512345.001 5412345.002 99.003\n"
               "512346.002 5412345.002 99.003\n512347.003 5412345.002 99.003\n"));
  const ShiftedCloud shifted = shiftedCloudOf (loadCloud (far));
  EXPECT_NEAR ((*shifted.cloud)[4].x - (*shifted.cloud)[3].x, 1.001, 1e-6);
}

TEST_F (CloudFile, HasNoPoseWhereItsViewpointIsNotFinite)
{
  std::string pcd = asciiPcd ("", "1 2 3\n4 5 6\n");
  const std::string usual = "VIEWPOINT 0 0 0 1 0 0 0";
  pcd.replace (pcd.find (usual), usual.size(), "VIEWPOINT nan 2 3 nan 0 0 0");
  const FileCloud cloud = loadCloud (folder_.write ("nowhere.pcd", pcd));
  EXPECT_EQ (cloud.origin, Eigen::Vector4f (Eigen::Vector4f::Zero()));
  EXPECT_EQ (cloud.orientation.w(), 1.0f);
}

TEST_F (CloudFile, ReadsTheVerticesOfAMesh)
{
  const std::string file = folder_.write (
      "mesh.ply",
      plyWith (
          "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 1\nproperty list uchar int vertex_indices\n",
          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  EXPECT_EQ (loadCloud (file).size(), 3u);
}

TEST_F (CloudFile, NamesWhatIsNoCloud)
{
  EXPECT_EQ (complaintAbout (folder_ / "missing.pcd"),
             "does not exist; check the name");
  EXPECT_EQ (complaintAbout (folder_ / std::string (256, 'n') + ".pcd"),
             "has a name that is too long; check it");
  EXPECT_EQ (complaintAbout (folder_.write ("a.abc", "1 2 3")),
             "has an unknown extension; give a .pcd, .ply, .las, .xyz, .txt, .pts or "
             ".csv file");
  EXPECT_EQ (complaintAbout (folder_.write ("empty.pcd", "")),
             "is empty; write it again");
  std::filesystem::create_directory (folder_ / "folder.pcd");
  EXPECT_EQ (complaintAbout (folder_ / "folder.pcd"),
             "is a folder; give a .pcd, .ply, .las, .xyz, .txt, .pts or .csv file");
  const std::string none = asciiPcd ("POINTS 0", "");
  EXPECT_EQ (complaintAbout (folder_.write (
                 "none.pcd",
                 std::string (none).replace (none.find ("WIDTH 2"), 7, "WIDTH 0"))),
             "has no points; give a cloud that has");
  const std::string no_vertex = plyWith (
      "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n", "");
  EXPECT_EQ (complaintAbout (folder_.write ("none.ply", no_vertex)),
             "has no points; give a cloud that has");
  EXPECT_EQ (complaintAbout (folder_.write ("xyw.pcd", asciiPcd ("FIELDS x y w"))),
             "has no field z; give a cloud with x, y and z");
  EXPECT_EQ (complaintAbout (folder_.write ("good.pcd", asciiPcd (""))), "");
}

TEST_F (CloudFile, NamesTheHeaderLineAtFault)
{
  const auto complaint = [&] (const std::string& change) {
    return complaintAbout (folder_.write ("bad.pcd", asciiPcd (change)));
  };
  const auto invalid = [] (const std::string& reason) {
    return "is no valid PCD file: " + reason + "; write it again";
  };
  EXPECT_EQ (complaint ("WIDTH -5"), invalid ("WIDTH -5 is out of range"));
  EXPECT_EQ (complaint ("WIDTH 4294967295"),
             invalid ("WIDTH 4294967295 is out of range"));
  EXPECT_EQ (complaint ("WIDTH"), invalid ("WIDTH is not one number"));
  EXPECT_EQ (complaint ("HEIGHT 7"), invalid ("WIDTH times HEIGHT is not POINTS"));
  EXPECT_EQ (complaint ("POINTS two"), invalid ("POINTS two is out of range"));
  EXPECT_EQ (complaint ("COUNT 1 1 -1"), invalid ("COUNT -1 is out of range"));
  EXPECT_EQ (complaint ("COUNT 1 1 99999999"),
             invalid ("COUNT 99999999 is out of range"));
  EXPECT_EQ (complaint ("SIZE 4 4 0"), invalid ("TYPE F with SIZE 0 does not exist"));
  EXPECT_EQ (complaint ("SIZE 4 4"),
             invalid ("FIELDS, SIZE, TYPE and COUNT differ in length"));
  EXPECT_EQ (complaint ("FIELDS"), invalid ("FIELDS names none"));
  EXPECT_EQ (complaint ("VIEWPOINT 0 0 0"), invalid ("VIEWPOINT is not seven numbers"));
  EXPECT_EQ (complaint ("VIEWPOINT 0 0 0 1 0 0 west"),
             invalid ("VIEWPOINT is not seven numbers"));
  EXPECT_EQ (complaint ("DATA morse"),
             invalid ("DATA is not ascii, binary or binary_compressed"));
  EXPECT_EQ (complaintAbout (folder_.write ("junk.pcd", std::string (5000, '\xfe'))),
             invalid ("its header has no line DATA"));
}

TEST_F (CloudFile, NoticesTruncatedData)
{
  const std::string truncated =
      "is truncated: its header promises more points than follow; "
      "copy or write it again";
  EXPECT_EQ (complaintAbout (folder_.write ("header.pcd", asciiPcd ("", ""))),
             truncated);
  EXPECT_EQ (
      complaintAbout (folder_.write ("line.pcd", asciiPcd ("", "1.5 2.5 3.5\n"))),
      truncated);
  pcl::io::savePCDFileBinary (folder_ / "binary.pcd", threePoints());
  pcl::io::savePCDFileBinaryCompressed (folder_ / "compressed.pcd", threePoints());
  pcl::io::savePLYFileBinary (folder_ / "binary.ply", threePoints());
  for (const char* name : {"binary.pcd", "compressed.pcd", "binary.ply"}) {
    const std::string whole = contentOf (folder_ / name);
    folder_.write (name, whole.substr (0, whole.size() - 20));
    EXPECT_EQ (complaintAbout (folder_ / name), truncated) << name;
  }
}

TEST_F (CloudFile, ReadsWhatPclsReadersStumbleOver)
{
  for (const std::string blank : {" ", "\t", "\r", "\v"})
    EXPECT_EQ (complaintAbout (
                   folder_.write ("blank.pcd", asciiPcd ("VERSION 0.7\n" + blank))),
               "");
  const std::string info = " obj_info num_cols\v2\n\tobj_info num_rows 1\r\n";
  EXPECT_EQ (complaintAbout (folder_.write (
                 "info.ply", plyWith (info + two_vertices, "1 2 3\r\n4 5 6\r\n"))),
             "");
}

TEST_F (CloudFile, ReadsColorsAndNormalsOfAPly)
{
  const FileCloud cloud = loadCloud (folder_.write (
      "colors.ply",
      plyWith ("element vertex 1\nproperty uchar blue\nproperty uchar alpha\n"
               "property float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty float nx\nproperty uchar intensity\n",
               "1 2 3 4 5 6 0.5 200\n")));
  pcl::PointCloud<pcl::PointXYZRGBA> colored;
  pcl::PointCloud<pcl::PointXYZI> others;
  pcl::fromPCLPointCloud2 (cloud.points, colored);
  pcl::fromPCLPointCloud2 (cloud.points, others);
  EXPECT_EQ (colored[0].rgba, 0x02060001u);
  EXPECT_EQ (others[0].intensity, 200.0f);
  EXPECT_TRUE (hasField (cloud, "normal_x"));
}

TEST_F (CloudFile, OrdersVerticesAsTheirGridDoes)
{
  const FileCloud cloud = loadCloud (folder_.write (
      "grid.ply",
      plyWith ("obj_info num_cols 3\nobj_info num_rows 1\n" + two_vertices +
                   "element range_grid 3\nproperty list uchar int vertex_indices\n",
               "1 2 3\n4 5 6\n1 1\n0\n1 0\n")));
  const ShiftedCloud shifted = shiftedCloudOf (cloud);
  ASSERT_EQ (shifted.cloud->size(), 3u);
  EXPECT_EQ ((*shifted.cloud)[0].x, 4.0f);
  EXPECT_TRUE (std::isnan ((*shifted.cloud)[1].x));
  EXPECT_EQ ((*shifted.cloud)[2].x, 1.0f);
}

TEST_F (CloudFile, NamesTheDamagedLineOfAnAsciiPcd)
{
  const auto complaint = [&] (const std::string& line) {
    return complaintAbout (
        folder_.write ("bad.pcd", asciiPcd ("", "1.00 2.00 3.00\n" + line + "\n")));
  };
  const auto at_line_12 = [] (const std::string& reason) {
    return "is damaged: line 12 " + reason + "; fix it or write the file again";
  };
  EXPECT_EQ (complaint ("4 5"), at_line_12 ("has 2 numbers instead of 3"));
  EXPECT_EQ (complaint ("4 5 6 7"), at_line_12 ("has 4 numbers instead of 3"));
  EXPECT_EQ (complaint (" "), at_line_12 ("has 0 numbers instead of 3"));
  EXPECT_EQ (complaint ("x y z"), at_line_12 ("has 'x', which is no number"));
  EXPECT_EQ (complaint ("4 5abc 6"), at_line_12 ("has '5abc', which is no number"));
  EXPECT_EQ (complaint ("4 5 6 # 7"), at_line_12 ("has '#', which is no number"));
  EXPECT_EQ (complaint ("4,5 5,5 6,5"), at_line_12 ("has '4,5', which is no number"));
  EXPECT_EQ (complaint ("4 5 +-6"), at_line_12 ("has '+-6', which is no number"));
}

TEST_F (CloudFile, NamesTheLineThatIsTooMuch)
{
  const std::string complaint = complaintAbout (
      folder_.write ("more.pcd", asciiPcd ("", "1 2 3\n4 5 6\n\n7 8 9\n")));
  EXPECT_EQ (
      complaint,
      "is damaged: line 14 is more than its header promises; fix it or write the "
      "file again");
  const std::string ply = plyWith (two_vertices, "1 2 3\n4 5 6\n7 8 9\n");
  EXPECT_EQ (
      complaintAbout (folder_.write ("more.ply", ply)),
      "is damaged: line 10 is more than its header promises; fix it or write the "
      "file again");
}

TEST_F (CloudFile, ReadsEverySpellingOfNumbersAndLineEnds)
{
  const std::string file = folder_.write (
      "fine.pcd", asciiPcd ("", "\n +1.  .5\t-1e2 \r\n\nNaN -inf INFINITY\n\r\n"));
  const ShiftedCloud shifted = shiftedCloudOf (loadCloud (file));
  EXPECT_EQ ((*shifted.cloud)[0].getVector3fMap(), Eigen::Vector3f (1, 0.5f, -100));
  EXPECT_TRUE (std::isnan ((*shifted.cloud)[1].x));
  EXPECT_TRUE (std::isinf ((*shifted.cloud)[1].z));
}

TEST_F (CloudFile, NamesTheDamagedLineOfAnAsciiPly)
{
  const auto complaint = [&] (const std::string& body) {
    return complaintAbout (folder_.write ("bad.ply", plyWith (two_vertices, body)));
  };
  const auto at_line = [] (const std::string& reason) {
    return "is damaged: line " + reason + "; fix it or write the file again";
  };
  EXPECT_EQ (complaint ("1 2 word\n4 5 6\n"),
             at_line ("8 has 'word', which is no number"));
  EXPECT_EQ (complaint ("1 2 3\n4 5 6,5\n"),
             at_line ("9 has '6,5', which is no number"));
  EXPECT_EQ (complaint ("1.0 2.0 3.0\n4 5\n"),
             at_line ("9 has 2 numbers instead of 3"));
  EXPECT_EQ (complaint ("1 2 3\n4 5 6 7\n"), at_line ("9 has 4 numbers instead of 3"));
}

TEST_F (CloudFile, NamesTheDamagedListOfAnAsciiPly)
{
  const std::string triangle =
      two_vertices + "element face 1\nproperty list uchar int vertex_indices\n";
  const auto complaint = [&] (const std::string& face) {
    return complaintAbout (
        folder_.write ("bad.ply", plyWith (triangle, "1 2 3\n4 5 6\n" + face + "\n")));
  };
  EXPECT_EQ (complaint ("2 0 1"), "");
  for (const std::string list : {"3 0 1", "2 0 1 2", "-1", "1e30", "nan"})
    EXPECT_EQ (
        complaint (list),
        "is damaged: line 12 has a list of another length than it says; fix it or "
        "write the file again")
        << list;
}

TEST_F (CloudFile, RefusesAGridOfVerticesThatAreNotThere)
{
  const std::string grid =
      "obj_info num_cols 2\nobj_info num_rows 1\n" + two_vertices +
      "element range_grid 2\nproperty list uchar int vertex_indices\n";
  const auto complaint = [&] (const std::string& cells) {
    return complaintAbout (
        folder_.write ("grid.ply", plyWith (grid, "1 2 3\n4 5 6\n" + cells)));
  };
  EXPECT_EQ (complaint ("1 1\n0\n"), "");
  for (const std::string cell : {"-1", "2", "nan", "1e30"})
    EXPECT_EQ (
        complaint ("1 1\n1 " + cell + "\n"),
        "is no valid PLY file: its range_grid names a vertex that does not exist; "
        "write it again")
        << cell;
}

TEST_F (CloudFile, RefusesABinaryGridOfVerticesThatAreNotThere)
{
  const std::string header =
      "obj_info num_cols 2\nobj_info num_rows 1\n" + two_vertices +
      "element range_grid 2\nproperty list uchar int vertex_indices\n";
  const auto complaint = [&] (const std::string& format, const std::string& index) {
    std::string ply = plyWith (header, "");
    ply.replace (ply.find ("ascii"), 5, format);
    return complaintAbout (
        folder_.write ("grid.ply", ply + std::string (24, '\0') + '\1' + index + '\0'));
  };
  const std::string negative (4, '\xff');
  EXPECT_EQ (complaint ("binary_little_endian", {'\1', '\0', '\0', '\0'}), "");
  EXPECT_EQ (complaint ("binary_big_endian", {'\0', '\0', '\0', '\1'}), "");
  for (const char* format : {"binary_little_endian", "binary_big_endian"})
    EXPECT_EQ (
        complaint (format, negative),
        "is no valid PLY file: its range_grid names a vertex that does not exist; "
        "write it again");
}

TEST_F (CloudFile, RefusesHeadersThatPromiseMoreThanTheirDataCanHold)
{
  const std::string truncated =
      "is truncated: its header promises more points than follow; "
      "copy or write it again";
  const std::uint32_t sizes[] = {50, 3'600'000'000};
  std::string bomb = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 300000000\nHEIGHT 1\n"
                     "POINTS 300000000\nDATA binary_compressed\n";
  bomb += std::string (reinterpret_cast<const char*> (sizes), sizeof (sizes)) +
          std::string (50, '\0');
  EXPECT_EQ (complaintAbout (folder_.write ("bomb.pcd", bomb)), truncated);
  EXPECT_EQ (complaintAbout (folder_.write (
                 "count.pcd", asciiPcd ("COUNT 1 1 1048576", "1 2 3\n4 5 6\n"))),
             truncated);
  std::string cells = "obj_info num_cols 3000\nobj_info num_rows 1\nelement vertex 1\n"
                      "property float x\nproperty float y\nproperty float z\n";
  for (int i = 0; i < 1000; ++i)
    cells += "property double d" + std::to_string (i) + "\n";
  cells += "element range_grid 3000\nproperty list uchar int vertex_indices\n";
  std::string grid = plyWith (cells, std::string (12 + 8000 + 3000, '\0'));
  grid.replace (grid.find ("ascii"), 5, "binary_little_endian");
  EXPECT_EQ (complaintAbout (folder_.write ("grid.ply", grid)), truncated);
}

TEST_F (CloudFile, RefusesPointsWhoseBytesPclCannotCount)
{
  // 2^16 fields of 2^23 bytes: those of 2^25 points are 2^64, which wraps to nothing.
  constexpr int fields = 1 << 16;
  const auto line = [] (std::string text, const std::string& word) {
    for (int i = 0; i < fields; ++i)
      text += " " + word;
    return text + "\n";
  };
  const std::string header = line ("FIELDS", "x") + line ("SIZE", "8") +
                             line ("TYPE", "F") + line ("COUNT", "1048576") +
                             "WIDTH 33554432\nHEIGHT 1\nPOINTS 33554432\nDATA ";
  for (const std::string kind : {"ascii", "binary", "binary_compressed"})
    EXPECT_EQ (
        complaintAbout (
            folder_.write ("wraps.pcd", header + kind + "\n" + std::string (16, '\0'))),
        "is no valid PCD file: its points do not have 1 to 2147483647 bytes each; "
        "write it again")
        << kind;
}

TEST_F (CloudFile, RefusesAHeaderThatGoesOnAndOn)
{
  const std::string endless (2'000'000, ' ');
  EXPECT_EQ (
      complaintAbout (folder_.write ("long.pcd", asciiPcd ("DATA ascii" + endless))),
      "is no valid PCD file: its header has no line DATA; write it again");
  EXPECT_EQ (complaintAbout (folder_.write (
                 "long.ply", plyWith ("comment" + endless + "\n" + two_vertices, ""))),
             "is no valid PLY file: its header has no line end_header; write it again");
}

TEST_F (CloudFile, RefusesAPlyOfMoreElementsAndPropertiesThanAnyHas)
{
  const auto many = [] (int count, const std::string& line, const std::string& rest) {
    std::string lines;
    for (int i = 0; i < count; ++i)
      lines.append (line).append (std::to_string (i)).append (rest).append ("\n");
    return lines;
  };
  const auto complaint = [&] (const std::string& lines) {
    return complaintAbout (
        folder_.write ("many.ply", plyWith (two_vertices + lines, "")));
  };
  EXPECT_EQ (complaint (many (1000, "element e", " 0")),
             "is no valid PLY file: it has more than 1000 elements; write it again");
  EXPECT_EQ (complaint (many (9998, "property float f", "")),
             "is no valid PLY file: its element vertex has more than 10000 properties; "
             "write it again");
}

TEST_F (CloudFile, NamesWhatIsNoPly)
{
  const auto complaint = [&] (const std::string& content) {
    return complaintAbout (folder_.write ("bad.ply", content));
  };
  const auto invalid = [] (const std::string& reason) {
    return "is no valid PLY file: " + reason + "; write it again";
  };
  EXPECT_EQ (complaint ("plot\n"), invalid ("its first line is not ply"));
  EXPECT_EQ (complaint ("ply\nformat ascii 1.0\n"),
             invalid ("its header has no line end_header"));
  EXPECT_EQ (complaint (plyWith ("element vertex -2\n", "")),
             invalid ("element vertex -2 is out of range"));
  EXPECT_EQ (complaint (plyWith ("", "")), invalid ("it has no element vertex"));
  EXPECT_EQ (complaint (plyWith ("element vertex 2\nproperty quad x\n", "")),
             invalid ("the property type quad does not exist"));
  EXPECT_NE (complaint (plyWith (two_vertices, "1 2 3\n")), "");
  EXPECT_EQ (complaint (plyWith (two_vertices, "1 2 3\n4 5 6\n")), "");
}
