// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// What the published readers of CloudCompare and Open3D look for in a file;
// src/doc/files.md says where.

#include "segment_program.h"
#include <support/las_bytes.h>

#include <array>
#include <map>
#include <sstream>

namespace {

using Lines = std::vector<std::string>;

class OtherPrograms : public Segment {
protected:
  /** \brief in.xyz: a wall at UTM coordinates with intensities. */
  void
  writeText () const
  {
    std::ostringstream text;
    text << std::fixed << "//X Y Z Intensity\n";
    text.precision (3);
    for (int i = 0; i < points_of_plane; ++i)
      text << 500000.001 << " " << 5400000 + 0.04 * (i / points_of_side) << " "
           << 0.04 * (i % points_of_side) << " " << i << "\n";
    folder_.write ("in.xyz", text.str());
  }

  /** \brief The lines in front of the data. */
  Lines
  headerOf (const std::string& file, const std::string& last) const
  {
    std::istringstream stream (contentOf (folder_ / file));
    Lines lines;
    for (std::string line; std::getline (stream, line);) {
      lines.push_back (line);
      if (line.rfind (last, 0) == 0)
        return lines;
    }
    ADD_FAILURE() << file << " has no line " << last;
    return lines;
  }
};

} // namespace

TEST_F (OtherPrograms, FindWhatTheyKnowInAPly)
{
  writeText();
  expectDone ("in.xyz out.ply --distances");
  const Lines header = headerOf ("out.ply", "end_header");
  EXPECT_EQ (header,
             (Lines{"ply",
                    "format binary_little_endian 1.0",
                    "element vertex 2500",
                    "property double x",
                    "property double y",
                    "property double z",
                    "property double Intensity",
                    "property float distance",
                    "property uint label",
                    "property uchar red",
                    "property uchar green",
                    "property uchar blue",
                    "end_header"}));
  std::size_t size = 2500 * (4 * 8 + 4 + 4 + 3);
  for (const std::string& line : header)
    size += line.size() + 1;
  EXPECT_EQ (contentOf (folder_ / "out.ply").size(), size);
}

TEST_F (OtherPrograms, FindSinglePrecisionAndColorsInAPcd)
{
  expectDone ("in.pcd out.pcd --distances");
  std::map<std::string, std::string> header;
  for (const std::string& line : headerOf ("out.pcd", "DATA"))
    header[line.substr (0, line.find (' '))] = line.substr (line.find (' ') + 1);
  // Open3D reads four bytes of each, and of no other size.
  EXPECT_EQ (header["FIELDS"], "x y z intensity distance label rgb");
  EXPECT_EQ (header["SIZE"], "4 4 4 4 4 4 4");
  EXPECT_EQ (header["TYPE"], "F F F F F U F");
  EXPECT_EQ (header["COUNT"], "1 1 1 1 1 1 1");
  EXPECT_EQ (header["WIDTH"], "5001");
  EXPECT_EQ (header["HEIGHT"], "1");
  EXPECT_EQ (header["POINTS"], "5001");
  EXPECT_EQ (header["DATA"], "binary");
}

TEST_F (OtherPrograms, FindTheExtraBytesOfALasWhereTheyCountThem)
{
  LasRecipe recipe;
  recipe.vlrs = {lasVlr ("LASF_Spec", 4, extraBytesField ("range", 3))};
  recipe.extra = {"12abc", "34def"}; // a range, and three bytes that nobody described
  folder_.write ("in.las", lasBytes (recipe));
  expectDone ("in.las out.las --distances");
  const std::string las = contentOf (folder_ / "out.las");
  constexpr std::size_t vlr_header = 54, description = 192;
  const std::size_t vlr = lasHeaderSize (4);
  EXPECT_STREQ (&las[vlr + 2], "LASF_Spec");
  const auto length = lasNumber<std::uint16_t> (las, vlr + 20);
  ASSERT_EQ (length, 6 * description);
  // CloudCompare counts one byte for what has the type 0, whatever its options say.
  const std::array<std::size_t, 10> sizes = {1, 1, 1, 2, 2, 4, 4, 8, 8, 4};
  std::map<std::string, std::size_t> places;
  std::size_t place = lasFormatLength (6);
  for (std::size_t at = vlr + vlr_header; at < vlr + vlr_header + length;
       at += description) {
    places[&las[at + 4]] = place;
    place += sizes.at (static_cast<std::size_t> (las[at + 2]));
  }
  EXPECT_EQ (place, lasNumber<std::uint16_t> (las, las_at::record_length));
  EXPECT_EQ (places["label"], lasFormatLength (6) + 5);
  EXPECT_EQ (places["distance"], lasFormatLength (6) + 9);
}
