// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <gtest/gtest.h>

#include <boost/algorithm/string/replace.hpp>

#include <cli/errors.h>
#include <io/cloud_file.h>
#include <io/labeled_pcd.h>
#include <io/number_list.h>
#include <io/shifted_cloud.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <limits>
#include <sstream>

using namespace pcl_ops::apps;

namespace {

/** \brief Two readings and, between them, a missing one, all with an intensity; the
 * cloud has a pose of the sensor. */
pcl::PointCloud<pcl::PointXYZI>
threePoints ()
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::PointXYZI> cloud;
  cloud.push_back ({1.0f, 2.0f, 3.0f, 0.5f});
  cloud.push_back ({not_a_number, not_a_number, not_a_number, 0.25f});
  cloud.push_back ({4.0f, 5.0f, 6.0f, 0.75f});
  cloud.is_dense = false;
  cloud.sensor_origin_ = Eigen::Vector4f (0.5f, -1.0f, 1.5f, 0.0f);
  cloud.sensor_orientation_ = Eigen::Quaternionf (0.0f, 1.0f, 0.0f, 0.0f);
  return cloud;
}

const std::string pcd_header =
    "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
    "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n";

/** \brief A PCD with \p line in place of the header line with the same first word. */
std::string
pcdWith (const std::string& line, const std::string& body = "1 2 3\n4 5 6\n")
{
  std::string pcd = pcd_header;
  const std::size_t begin = pcd.find (line.substr (0, line.find (' ')));
  pcd.replace (begin, pcd.find ('\n', begin) - begin, line);
  return pcd + body;
}

const std::string two_vertices =
    "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
const std::string triangle =
    two_vertices + "element face 1\nproperty list uchar int vertex_indices\n";

/** \brief A PLY with these elements in its header and this body. */
std::string
plyWith (const std::string& elements,
         const std::string& body,
         const std::string& format = "ascii")
{
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}

/** \brief Lines of \p begin, the number of the line (from 0), and \p end. */
std::string
numberedLines (int count, const std::string& begin, const std::string& end = "")
{
  std::string lines;
  for (int i = 0; i < count; ++i)
    lines.append (begin).append (std::to_string (i)).append (end).append ("\n");
  return lines;
}

const std::string truncated =
    "is truncated: its header promises more points than follow; copy or write it again";

std::string
invalidPcd (const std::string& reason)
{
  return "is no valid PCD file: " + reason + "; write it again";
}

/** \brief A LAS with a variable length record before and one behind its points, and
 * with some numbers overwritten.
 * \param[in] changes type, offset [byte] and number of each, as "u16 94 374"; the only
 * type of a fraction is f64 */
std::string
lasWith (const std::string& changes)
{
  LasRecipe recipe;
  recipe.vlrs = {lasVlr ("someone", 7, "content")};
  recipe.evlrs = {lasVlr<LasHeader::UInt64> ("someone", 9, "content")};
  std::string las = lasBytes (recipe), type, number;
  std::istringstream words (changes);
  for (std::size_t offset; words >> type >> offset >> number;) {
    const std::size_t bits = std::stoul (type.substr (1));
    const std::string bytes =
        type[0] == 'f' ? bytesOf (boost::endian::little_float64_t (std::stod (number)))
                       : bytesOf (LasHeader::UInt64 (std::stoull (number)));
    las.replace (offset, bits / 8, bytes, 0, bits / 8);
  }
  return las;
}

/** \brief A .npy file with this description (below 256 bytes) in its header and these
 * data. */
std::string
npyWith (const std::string& description, const std::string& data)
{
  const std::string length (1, static_cast<char> (description.size()));
  return "\x93NUMPY\1" + std::string (1, '\0') + length + std::string (1, '\0') +
         description + data;
}

std::string
npyWith (const std::string& type,
         const std::string& is_fortran,
         const std::string& shape,
         const std::string& data)
{
  return npyWith ("{'descr': '" + type + "', 'fortran_order': " + is_fortran +
                      ", 'shape': " + shape + ", }",
                  data);
}

template <typename Number>
std::string
bytesOfNumbers (const std::vector<Number>& numbers)
{
  return {reinterpret_cast<const char*> (numbers.data()),
          numbers.size() * sizeof (Number)};
}

/** \brief The content of the file that a row of read_files.tsv or refused_files.tsv is
 * about.
 * \param[in] kind the first column: names the part of the file that \p text is (a line
 * of the header, the body, a line of it ...); with another name \p text is all of it
 * \param[in] text the second column */
std::string
contentOfRow (const std::string& kind, std::string text)
{
  const std::pair<const char*, const char*> escapes[] = {
      {"\\n", "\n"}, {"\\t", "\t"}, {"\\r", "\r"}, {"\\v", "\v"}};
  for (const auto& [escape, character] : escapes)
    boost::replace_all (text, escape, character);
  if (kind == "header.pcd")
    return pcdWith (text);
  if (kind == "body.pcd")
    return pcd_header + text;
  if (kind == "line.pcd")
    return pcd_header + "1.00 2.00 3.00\n" + text + "\n";
  if (kind == "elements.ply")
    return plyWith (text, "");
  if (kind == "body.ply")
    return plyWith (two_vertices, text);
  if (kind == "list.ply")
    return plyWith (triangle, "1 2 3\n4 5 6\n" + text + "\n");
  return kind == "number.las" ? lasWith (text) : text;
}

using CloudFile = CloudFolder;
using TextFile = CloudFolder;

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
    EXPECT_EQ (textOf (loaded),
               "x 1 nan 4; y 2 nan 5; z 3 nan 6; intensity 0.5 0.25 0.75");
    if (name.find (".pcd") == std::string::npos)
      continue; // the pose of a PLY is not read
    EXPECT_TRUE (loaded.origin.isApprox (Eigen::Vector3d (0.5, -1, 1.5)));
    EXPECT_NEAR (std::abs (loaded.orientation.x()), 1.0, 1e-6);
  }
}

TEST_F (CloudFile, SkipsEmptyLinesOfEitherEnd)
{
  for (const std::string end : {"\n", "\r\n"}) {
    const std::string points = "1 2 3" + end + end + "4 5 6" + end;
    EXPECT_EQ (textOf (load ("a.pcd", pcdWith ("POINTS 2", points))),
               "x 1 4; y 2 5; z 3 6");
  }
}

TEST_F (CloudFile, KeepsAPoseInMapCoordinates)
{
  const std::string pose =
      "VIEWPOINT 691002.1 5334012.3 520.5 0.9238795325 0 0 0.3826834324";
  const FileCloud cloud = load ("utm.pcd", pcdWith (pose));
  saveCloud (folder_ / "saved.pcd", cloud);
  EXPECT_NE (contentOf (folder_ / "saved.pcd").find (pose + '\n'), std::string::npos);
}

TEST_F (CloudFile, WritesAPoseInSinglePrecisionWithTheDigitsThatTellIt)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  cloud.emplace_back();
  cloud.sensor_origin_ = {0.1f, 12345.678f, 0.0f, 0.0f};
  saveLabeledPcd (folder_ / "single.pcd", cloud);
  EXPECT_NE (
      contentOf (folder_ / "single.pcd").find ("VIEWPOINT 0.1 12345.678 0 1 0 0 0\n"),
      std::string::npos);
}

TEST_F (CloudFile, SavesEveryByteThatPclWroteAndCompressed)
{
  // Repeated and random bytes, and more of them than a reference of the compression
  // reaches back.
  pcl::PointCloud<pcl::PointXYZRGBA> cloud;
  cloud.sensor_origin_ = Eigen::Vector4f (0.5f, -1.0f, 1.5f, 0.0f);
  for (std::uint32_t i = 0; i < 5000; ++i) {
    pcl::PointXYZRGBA point;
    point.x = static_cast<float> (i % 7);
    point.y = std::sin (static_cast<float> (i * i));
    point.z = 0.0f;
    point.rgba = i * 2654435761U;
    cloud.push_back (point);
  }
  pcl::io::savePCDFileBinary (folder_ / "plain.pcd", cloud);
  pcl::io::savePCDFileBinaryCompressed (folder_ / "small.pcd", cloud);
  for (const char* name : {"plain.pcd", "small.pcd"}) {
    saveCloud (folder_ / "again.pcd", loadCloud (folder_ / name));
    EXPECT_TRUE (contentOf (folder_ / "again.pcd") ==
                 contentOf (folder_ / "plain.pcd"));
  }
}

TEST_F (CloudFile, ReplacesLabelsAndColorsTheInputHad)
{
  FileCloud cloud = load ("in.pcd",
                          "FIELDS x y label rgba z\nSIZE 4 4 1 4 4\nTYPE F F U U F\n"
                          "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 7 255 3\n");
  const std::uint32_t label = 70000;
  const float color = 0.5f;
  setField (cloud, "label", pcl::PCLPointField::UINT32, &label);
  setField (cloud, "rgb", pcl::PCLPointField::FLOAT32, &color, "rgba");
  EXPECT_EQ (textOf (cloud), "x 1; y 2; label 70000; rgb 0.5; rgba 255; z 3");
}

TEST_F (CloudFile, KeepsMillimetersFarFromZeroAndBesideAPointFarFromAllOthers)
{
  const std::string vertices =
      "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n";
  const ShiftedCloud shifted = shiftedCloudOf (load (
      "far.ply",
      plyWith (vertices,
               "1e8 1e8 0\n0 0 0\n512345.001 5412345.002 99.003\n"
               "512346.002 5412345.002 99.003\n512347.003 5412345.002 99.003\n")));
  EXPECT_NEAR ((*shifted.cloud)[4].x - (*shifted.cloud)[3].x, 1.001, 1e-6);
  EXPECT_NEAR ((*shifted.cloud)[4].x + shifted.shift.x(), 512347.003, 1e-6);
}

TEST_F (CloudFile, OfDoublePrecisionIsMovedAlikeInAnyOrderAndBesideMissingReadings)
{
  std::string text, reversed, zeros;
  for (int i = 0; i < 2000; ++i) {
    const std::string line = std::to_string (512345.001 + i) + " 5412345.002 99.003\n";
    text += line;
    reversed = line + reversed;
    zeros += "0 0 0\n";
  }
  const auto shiftOf = [&] (const std::string& lines) {
    return shiftedCloudOf (load ("far.xyz", lines)).shift;
  };
  const Eigen::Vector3d shift = shiftOf (text);
  // The median is rounded to a step of 16 to 32 times the median deviation from it.
  constexpr double median = 513345.0, deviation = 500.0; // of x [m]
  EXPECT_NEAR (shift.x(), median, 32.0 * deviation / 2.0);
  EXPECT_EQ (shiftOf (reversed), shift);
  EXPECT_EQ (shiftOf (zeros + text + zeros), shift);
}

TEST_F (CloudFile, IsNotMovedWhereSinglePrecisionHoldsAllItsDigits)
{
  EXPECT_TRUE (shiftedCloudOf (load ("a.xyz", "1000 2.5 3\nnan nan nan\n-7 8 9\n"))
                   .shift.isZero (0.0));
}

TEST_F (CloudFile, HasNoPoseWhereItsViewpointIsNotFinite)
{
  const FileCloud cloud = load ("nowhere.pcd", pcdWith ("VIEWPOINT nan 2 3 nan 0 0 0"));
  EXPECT_EQ (cloud.origin, Eigen::Vector3d (Eigen::Vector3d::Zero()));
  EXPECT_EQ (cloud.orientation.w(), 1.0f);
}

TEST_F (CloudFile, HasWhatTheTableSays)
{
  const auto rows = tableIn (PCL_OPS_READ_FILES);
  ASSERT_GT (rows.size(), 30u);
  for (const auto& row : rows) {
    SCOPED_TRACE (row.at (0) + " " + row.at (1));
    EXPECT_EQ (textOf (load (row[0], contentOfRow (row[0], row[1]))), row.at (2));
  }
}

TEST_F (CloudFile, HasTinyNumbersAlsoWhereALocaleHasADecimalComma)
{
  const std::string c_locale = std::setlocale (LC_NUMERIC, nullptr);
  const char* const wanted[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "nl_NL.UTF-8"};
  const bool has_comma =
      std::any_of (std::begin (wanted), std::end (wanted), [] (const char* locale) {
        return std::setlocale (LC_NUMERIC, locale) != nullptr;
      });
  const std::string text = textOf (load ("tiny.xyz", "1.5e-400 2 3\n"));
  std::setlocale (LC_NUMERIC, c_locale.c_str());
  if (!has_comma)
    GTEST_SKIP() << "there is no such locale";
  EXPECT_EQ (text, "x 0; y 2; z 3");
}

TEST_F (CloudFile, IsRefusedForWhatTheTableSays)
{
  const auto rows = tableIn (PCL_OPS_REFUSED_FILES);
  ASSERT_GT (rows.size(), 60u);
  for (const auto& row : rows) {
    SCOPED_TRACE (row.at (0) + " " + row.at (1));
    EXPECT_EQ (complaintAbout (row[0], contentOfRow (row[0], row[1])), row.at (2));
  }
}

TEST_F (CloudFile, IsRefusedForWhatIsTooLong)
{
  EXPECT_EQ (complaintAbout (folder_ / std::string (256, 'n') + ".pcd"),
             "has a name that is too long; check it");
  EXPECT_EQ (complaintAbout ("bad.pcd", std::string (5000, '\xfe')),
             invalidPcd ("its header has no line DATA"));
  const std::string blanks (2'000'000, ' ');
  EXPECT_EQ (complaintAbout ("bad.pcd", pcdWith ("DATA ascii" + blanks)),
             invalidPcd ("its header is longer than 1 MiB"));
  const std::pair<std::string, std::string> rows[] = {
      {"comment" + blanks + "\n" + two_vertices, "its header is longer than 1 MiB"},
      {two_vertices + numberedLines (1000, "element e", " 0"),
       "it has more than 1000 elements"},
      {two_vertices + numberedLines (9998, "property float f"),
       "its element vertex has more than 10000 properties"}};
  for (const auto& [elements, reason] : rows)
    EXPECT_EQ (complaintAbout ("bad.ply", plyWith (elements, "")),
               "is no valid PLY file: " + reason + "; write it again");
  // 2^16 fields of 8 x 2^20 = 2^23 bytes for each of 2^25 points: in 64 bits, the
  // product of these is 0.
  std::string many;
  for (const char* line : {"FIELDS x", "SIZE 8", "TYPE F", "COUNT 1048576"}) {
    many += line;
    for (int i = 1; i < 1 << 16; ++i)
      many += std::strchr (line, ' '); // the word again
    many += "\n";
  }
  many += "WIDTH 33554432\nHEIGHT 1\nPOINTS 33554432\nDATA ascii\n";
  EXPECT_EQ (complaintAbout ("bad.pcd", many),
             invalidPcd ("its points do not have 1 to 2147483647 bytes each"));
}

TEST_F (CloudFile, ReadsBinaryOfEitherOrderAndListsOfAnyLength)
{
  const auto binary = [] (const std::string& format, const std::string& vertices) {
    const std::string face = "\3" + std::string (12, '1'); // length, three numbers
    return plyWith (triangle, vertices + face, format);
  };
  EXPECT_EQ (complaintAbout ("good.ply", contentOfRow ("list.ply", "2 0 1")), "");
  const std::string zeros (20, '\0'); // all but one of the six floats of two vertices
  const std::pair<const char*, std::string> rows[] = {
      {"binary_little_endian", std::string ("\0\0\x80\x3f", 4)},
      {"binary_big_endian", std::string ("\x3f\x80\0\0", 4)}};
  for (const auto& [format, one] : rows) {
    const std::string whole = binary (format, one + zeros);
    EXPECT_EQ (textOf (load ("a.ply", whole)), "x 1 0; y 0 0; z 0 0");
    EXPECT_EQ (complaintAbout ("a.ply", whole.substr (0, whole.size() - 1)), truncated);
  }
}

TEST_F (CloudFile, RefusesCompressedDataThatAreCutOrCannotHoldWhatIsPromised)
{
  pcl::io::savePCDFileBinaryCompressed (folder_ / "a.pcd", threePoints());
  const std::string whole = contentOf (folder_ / "a.pcd");
  EXPECT_EQ (complaintAbout ("a.pcd", whole.substr (0, whole.size() - 20)), truncated);
  const std::uint32_t sizes[] = {50, 3'600'000'000}; // compressed, promised [byte]
  std::string bomb = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 300000000\nHEIGHT 1\n"
                     "POINTS 300000000\nDATA binary_compressed\n";
  bomb += std::string (reinterpret_cast<const char*> (sizes), sizeof (sizes)) +
          std::string (50, '\0');
  EXPECT_EQ (complaintAbout ("bomb.pcd", bomb), truncated);
}

TEST_F (CloudFile, OfKittiHasFourNumbersForEachPointAndOfNuScenesFive)
{
  const std::string bytes = bytesOfNumbers<float> ({1, 2, 3, 0.5f, 7, 4, 5, 6, 1, 8});
  EXPECT_EQ (textOf (load ("000001.bin", bytes.substr (0, 16))),
             "x 1; y 2; z 3; intensity 0.5");
  EXPECT_EQ (textOf (load ("a.pcd.bin", bytes)),
             "x 1 4; y 2 5; z 3 6; intensity 0.5 1; ring 7 8");
  EXPECT_EQ (complaintAbout ("000001.bin", bytes),
             "is no valid KITTI file: its size is no multiple of the 16 bytes of a "
             "point; write it again");
  EXPECT_EQ (complaintAbout ("code.bin", "a text, no points"),
             "is no valid KITTI file: its size is no multiple of the 16 bytes of a "
             "point; write it again");
  EXPECT_EQ (complaintAbout ("code.bin", std::string (32, '\xfe')),
             "is no valid KITTI file: most of its numbers are no coordinates in "
             "meters; write it again");
}

TEST_F (CloudFile, OfKittiMayBeFarFromZeroAsUtmIs)
{
  EXPECT_EQ (textOf (load ("utm.bin", bytesOfNumbers<float> ({500001, 5400001, 3, 0}))),
             "x 500001; y 5400001; z 3; intensity 0");
}

TEST_F (CloudFile, OfKittiIsRefusedWhereThreeNumbersAreAPoint)
{
  std::vector<float> floor;
  for (int i = 0; i < 200; ++i)
    floor.insert (floor.end(), {i * 0.1f, i % 10 * 1.0f, 2.0f});
  EXPECT_EQ (complaintAbout ("xyz.bin", bytesOfNumbers (floor)),
             "is no valid KITTI file: it seems to have three numbers for each point, "
             "not x, y, z and intensity; write it again");
}

TEST_F (CloudFile, OfNumPyKeepsTypesColumnsAndShape)
{
  const auto textOfArray = [&] (const std::string& type, auto numbers, auto... others) {
    return textOf (load ("a.npy", npyWith (type, others..., bytesOfNumbers (numbers))));
  };
  const std::vector<std::int8_t> two_points = {1, 2, 3, -4, 5, 6};
  const std::string expected = "x 1 -4; y 2 5; z 3 6";
  EXPECT_EQ (textOfArray ("|i1", two_points, "False", "(2, 3)"), expected);
  const std::vector<double> doubles (two_points.begin(), two_points.end());
  EXPECT_EQ (textOfArray ("<f8", doubles, "False", "(2, 3)"), expected);
  const std::vector<std::int64_t> integers (two_points.begin(), two_points.end());
  EXPECT_EQ (textOfArray ("<i8", integers, "False", "(2, 3)"), expected);
  EXPECT_EQ (
      textOfArray ("<u2", std::vector<std::uint16_t>{1, 2, 3, 4}, "False", "(1, 4)"),
      "x 1; y 2; z 3; field_4 4");
  EXPECT_EQ (
      textOfArray ("<f4", std::vector<float>{1, 4, 2, 5, 3, 6}, "True", "(2, 3)"),
      "x 1 4; y 2 5; z 3 6");
  // An image of 2 rows and 3 columns, in the order of C and in that of Fortran.
  std::vector<float> image (2 * 3 * 3), transposed (image.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const std::size_t row = i / 9, column = i / 3 % 3, number = i % 3;
    image[i] = transposed[row + 2 * column + 6 * number] = static_cast<float> (i);
  }
  const std::string organized =
      "x 0 3 6 9 12 15; y 1 4 7 10 13 16; z 2 5 8 11 14 17; height 2";
  EXPECT_EQ (textOfArray ("<f4", image, "False", "(2, 3, 3)"), organized);
  EXPECT_EQ (textOfArray ("<f4", transposed, "True", "(2, 3, 3)"), organized);
}

TEST_F (CloudFile, OfNumPyIsRefusedForWhatIsNoArrayOfPoints)
{
  const auto complaintAboutArray = [&] (auto... parts) {
    return complaintAbout ("a.npy", npyWith (parts...));
  };
  const std::string point (12, '\0');
  const std::string type = "has no plain numbers that are little endian; save "
                           "array.astype ('<f4')";
  for (const char* name : {">f4", "<f2", "|b1", "<c8", "|O", "", "f4"})
    EXPECT_EQ (complaintAboutArray (name, "False", "(1, 3)", point), type) << name;
  EXPECT_EQ (complaintAboutArray ("{'descr': [('x', '<f4'), ('y', '<f4')], "
                                  "'fortran_order': False, 'shape': (1,), }",
                                  point),
             type);
  for (const char* shape : {"()", "(3,)", "(3, 1)", "(1, 1, 1, 3)", "(1, 1001)"})
    EXPECT_EQ (complaintAboutArray ("<f4", "False", shape, point),
               "has an array of another shape than (N, 3) or (H, W, 3), or more "
               "columns; save array.T or array.reshape (-1, 3)")
        << shape;
  EXPECT_EQ (complaintAboutArray ("<f4", "False", "(0, 3)", ""),
             "has no points; give a cloud that has");
  for (const char* shape : {"(2, 3)", "(2147483647, 3)", "(2147483647, 2147483647, 3)"})
    EXPECT_EQ (complaintAboutArray ("<f4", "False", shape, point), truncated) << shape;
  const auto invalid = [] (const std::string& reason) {
    return "is no valid NumPy file: " + reason + "; write it again";
  };
  EXPECT_EQ (complaintAboutArray ("<f4", "False", "(1, 3)", point + point),
             invalid ("it has more numbers than its shape says"));
  EXPECT_EQ (complaintAboutArray ("<f4", "False", "(1, -3)", point),
             invalid ("its shape -3 is out of range"));
  EXPECT_EQ (complaintAboutArray ("{'descr': '<f4'}", point),
             invalid ("its header has no fortran_order"));
  EXPECT_EQ (complaintAbout ("a.npy", "PK\3\4"),
             invalid ("its first bytes are not \\x93NUMPY"));
  EXPECT_EQ (complaintAbout ("a.npy", "\x93NUMPY\1"), truncated);
  EXPECT_EQ (complaintAbout ("a.npy", "\x93NUMPY\2" + std::string (1, '\0') + point),
             invalid ("its header has no descr"));
  EXPECT_EQ (complaintAbout ("a.npy", "\x93NUMPY\2" + std::string (5, '\1') + point),
             invalid ("its header is longer than 64 KiB"));
}

TEST_F (CloudFile, OfNumPyIsRefusedWhereCoordinatesAreInRows)
{
  const auto complaintAboutArray = [&] (const std::string& shape) {
    return complaintAbout ("a.npy", npyWith ("<f4", "False", shape, ""));
  };
  EXPECT_EQ (complaintAboutArray ("(3, 600)"),
             "has an array of shape (3, 600), which are coordinates in rows; save "
             "array.T");
  EXPECT_EQ (complaintAboutArray ("(3, 480, 640)"),
             "has an array of shape (3, H, W), not (H, W, 3); save numpy.moveaxis "
             "(array, 0, -1)");
}

TEST_F (CloudFile, OfPtxKnowsWhereItsScannersWere)
{
  const auto scan = [] (const std::string& scanner, const std::string& translation) {
    return "1\n1\n" + scanner + "\n0 1 0\n-1 0 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n" +
           translation + " 1\n1 2 3 0.5\n";
  };
  const FileCloud one = load ("a.ptx", scan ("10 20 30", "10 20 30"));
  EXPECT_EQ (one.origin, Eigen::Vector3d (10, 20, 30));
  EXPECT_TRUE (one.orientation.isApprox (
      Eigen::Quaterniond (std::sqrt (0.5), 0.0, 0.0, std::sqrt (0.5)), 1e-6));
  EXPECT_TRUE (one.scans.empty());
  EXPECT_EQ (load ("a.ptx", scan ("0 0 0", "1 2 3")).origin, Eigen::Vector3d (1, 2, 3))
      << "where only the matrix says it";
  const FileCloud two =
      load ("a.ptx", scan ("1 2 3", "1 2 3") + scan ("4 5 6", "1 2 3"));
  ASSERT_EQ (two.scans.size(), 2u);
  EXPECT_EQ (two.scans[1].first, 1u);
  EXPECT_EQ (two.scans[1].position, Eigen::Vector3d (4, 5, 6));
  EXPECT_TRUE (two.origin.isZero (0.0)) << "scans have two positions";
}

TEST_F (TextFile, IsReadByEachOfItsExtensionsAndInFoldersByThoseOfClouds)
{
  for (const char* name :
       {"a.xyz", "a.xyzrgb", "a.txt", "a.pts", "a.asc", "a.csv", "a.XYZ"})
    EXPECT_EQ (load (name, "1 2 3\n").size(), 1u) << name;
  for (const char* name : {"a.xyz", "a.xyzrgb", "a.pts", "a.asc", "a.ptx", "a.bin"})
    EXPECT_TRUE (isCloudFile (name)) << name;
  for (const char* name : {"README.txt", "planes.csv", "a.npy", "a.obj", "a.e57"})
    EXPECT_FALSE (isCloudFile (name)) << name;
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
  // A million line ends, or a million characters of a comment, are no million points.
  std::string text = "1 2 3\n" + std::string (1000000, '\n');
  EXPECT_LT (load ("in.xyz", text).points.data.capacity(), 10u * text.size());
  text = "1 2 3\n4 5 6\n" + std::string (1000000, '#');
  EXPECT_LT (load ("in.xyz", text).points.data.capacity(), 10u * text.size());
}

TEST_F (CloudFile, OfNumbersMayBeginWithTheMarkOfUtf8)
{
  const std::string mark = "\xef\xbb\xbf";
  const std::string file = folder_.write ("labels.txt", mark + "1\n2\n");
  EXPECT_EQ (readTextNumbers (file), (std::vector<double>{1.0, 2.0}));
}
