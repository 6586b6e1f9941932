// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/cloud_file.h>
#include <io/las_file.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <cmath>

using namespace pcl_ops::apps;

namespace {

class LasFileTest : public CloudFolder {
protected:
  /** \brief The bytes of the file that adding these labels to a LAS gives. */
  std::string
  labeled (const std::string& las, const std::vector<std::uint32_t>& labels) const
  {
    saveLabeledLas (folder_ / "labeled.las", *load ("a.las", las).las, labels);
    return contentOf (folder_ / "labeled.las");
  }
};

/** \brief The two records of a recipe, each with its label behind it. */
std::string
recordsWithLabels (const LasRecipe& recipe, std::uint32_t first, std::uint32_t second)
{
  return lasRecord (recipe, 0) + bytesOf (LasHeader::UInt32 (first)) +
         lasRecord (recipe, 1) + bytesOf (LasHeader::UInt32 (second));
}

std::string
invalid (const std::string& reason)
{
  return "is no valid LAS file: " + reason + "; write it again";
}

} // namespace

TEST_F (LasFileTest, HasTheCoordinatesAndTheIntensityOfEveryPointFormat)
{
  // The intensity is in bytes 12 and 13 of a record: 12 + 256 * 13 = 3340, and with 16
  // more in each byte of the second record 7452 (lasRecord).
  for (std::uint8_t minor = 0; minor <= 4; ++minor)
    for (std::uint8_t format = 0; format <= 10; ++format)
      EXPECT_EQ (textOf (load ("a.las", lasBytes ({minor, format}))),
                 "x 500000.001 500000.004; y 5400000.002 5400000.005; z 0.003 0.006; "
                 "intensity 3340 7452")
          << int (minor) << ", format " << int (format);
}

TEST_F (LasFileTest, KeepsEveryRawCoordinateOfMorePointsThanABlockHas)
{
  LasRecipe recipe;
  constexpr std::int32_t size = 40000;  // a block has 16384
  constexpr std::int32_t step = 100003; // x goes through nearly all of 32 bits
  recipe.points.clear();
  for (std::int32_t i = -size / 2; i < size / 2; ++i)
    recipe.points.push_back ({step * i, 7 * i, -i});
  const FileCloud cloud = load ("a.las", lasBytes (recipe));
  ASSERT_EQ (cloud.size(), static_cast<std::size_t> (size));
  const std::array names = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    const std::vector<double> values = valuesOf (cloud, names[axis]);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      ASSERT_EQ (std::lround ((values[i] - recipe.offset[axis]) / recipe.scale),
                 recipe.points[i][axis])
          << names[axis];
  }
}

TEST_F (LasFileTest, TellsThePositionOfAnyPointInAnyOrder)
{
  LasRecipe recipe;
  recipe.points.clear();
  constexpr std::int32_t size = 10000; // at most 4096 are read at once
  for (std::int32_t i = 0; i < size; ++i)
    recipe.points.push_back ({i, 0, 0});
  const std::shared_ptr<LasFile> las = load ("a.las", lasBytes (recipe)).las;
  const auto expectPosition = [&las] (std::uint64_t point) {
    const double from_offset = las->position (point).x() - 500000;
    ASSERT_EQ (std::lround (from_offset / 0.001), static_cast<long> (point));
  };
  for (std::uint64_t i = 0; i < size; ++i)
    expectPosition (i);
  for (const std::uint64_t i : {0, 9999, 1, 2, 5000, 4999, 5000, 5001, 9998, 9999})
    expectPosition (i);
}

TEST_F (LasFileTest, IsLabeledWithEveryOtherByteKept)
{
  constexpr std::uint32_t added = vlr_header_length + extra_bytes_field_length;
  for (std::uint8_t minor = 0; minor <= 4; ++minor) {
    SCOPED_TRACE (int (minor));
    LasRecipe recipe{minor, 3}; // records of 34 bytes
    recipe.vlrs = {lasVlr ("someone", 7, "content"),
                   lasVlr ("LASF_Projection", 1, "p")};
    recipe.gap = "between";
    if (minor == 4)
      recipe.evlrs = {lasVlr<LasHeader::UInt64> ("someone", 9, "behind the points")};
    std::string expected = lasBytes (recipe);
    const std::uint32_t points = headerIn (expected).points_offset;
    expected.resize (points);
    expected += recordsWithLabels (recipe, 70000, 0);
    headerIn (expected).points_offset = points + added;
    headerIn (expected).vlr_count = 3;
    headerIn (expected).record_length = 34 + 4;
    if (minor == 4) {
      headerIn (expected).evlr_offset = expected.size() + added;
      expected += recipe.evlrs[0];
    }
    std::string after = labeled (lasBytes (recipe), {70000, 0});
    after.erase (points - recipe.gap.size(), added);
    EXPECT_TRUE (after == expected);
  }
}

TEST_F (LasFileTest, OfVersion10HasItsPointsBehindTheTwoBytesThatMarkTheirBegin)
{
  const LasRecipe recipe{0, 1};
  LasRecipe marked = recipe;
  marked.gap = "\xdd\xcc";
  std::string las = lasBytes (marked);
  const std::string expected = textOf (load ("a.las", lasBytes (recipe)));
  EXPECT_EQ (textOf (load ("a.las", las)), expected);
  headerIn (las).points_offset = headerIn (las).header_size;
  EXPECT_EQ (textOf (load ("a.las", las)), expected)
      << "where the offset is that of the mark, not of the points";
  std::string after = labeled (las, {5, 6});
  EXPECT_EQ (after.substr (headerIn (after).points_offset),
             recordsWithLabels (recipe, 5, 6));
  const std::string record = after.substr (headerIn (after).header_size);
  EXPECT_EQ (record.substr (0, 2), "\xbb\xaa")
      << "the signature of a variable length record of LAS 1.0";
}

TEST_F (LasFileTest, OfVersion10BeginsWithAPointWhoseBytesAreThatMark)
{
  LasRecipe recipe{0, 1};
  recipe.points[0][0] = 0xccdd; // 52445
  EXPECT_EQ (valuesOf (load ("a.las", lasBytes (recipe)), "x").at (0), 500052.445);
}

TEST_F (LasFileTest, MovesTheWaveformsBehindThePoints)
{
  std::string las = lasBytes (LasRecipe{3, 4});
  headerIn (las).waveform_offset = las.size();
  std::string after = labeled (las + "waveforms", {1, 2});
  EXPECT_EQ (after.substr (headerIn (after).waveform_offset), "waveforms");
}

TEST_F (LasFileTest, AddsTheLabelToTheExtraBytesThereAre)
{
  LasRecipe recipe;
  // Two of the five bytes of each point are described; three others follow.
  recipe.extra = {"ab123", "cd456"};
  recipe.vlrs = {lasVlr ("LASF_Spec", 4, extraBytesField ("range", las_uint16)),
                 lasVlr ("someone", 7, "content")};
  std::string after = labeled (lasBytes (recipe), {5, 6});
  constexpr std::size_t vlr = 375; // its offset, behind the header of LAS 1.4
  constexpr std::size_t length_in_vlr = 2 + 16 + 2;
  constexpr std::size_t fields = vlr + vlr_header_length;
  constexpr std::size_t field = extra_bytes_field_length;
  constexpr std::size_t name_in_field = 4;
  EXPECT_EQ (headerIn (after).vlr_count, 2u);
  ASSERT_EQ (reinterpret_cast<LasHeader::UInt16&> (after[vlr + length_in_vlr]),
             5 * field)
      << "range, three single bytes, and label";
  EXPECT_EQ (after.substr (fields, field), extraBytesField ("range", las_uint16));
  for (std::size_t i = 1; i <= 3; ++i)
    EXPECT_EQ (after.substr (fields + i * field, field),
               extraBytesField ("", las_undocumented, 1))
        << "one for each byte without a description: CloudCompare counts a longer one "
           "as a single byte";
  EXPECT_STREQ (&after[fields + 4 * field + name_in_field], "label");
  EXPECT_EQ (after.substr (fields + 5 * field, recipe.vlrs[1].size()), recipe.vlrs[1]);
  EXPECT_EQ (after.substr (headerIn (after).points_offset),
             recordsWithLabels (recipe, 5, 6));
}

TEST_F (LasFileTest, ReadsAndReplacesTheLabelsItWrote)
{
  const std::string first = labeled (lasBytes ({}), {70000, 3});
  EXPECT_TRUE (contains (textOf (load ("a.las", first)), "; label 70000 3"));
  EXPECT_TRUE (labeled (first, {3, 4}) == labeled (lasBytes ({}), {3, 4}));
}

TEST_F (LasFileTest, SaysThatItHasNoRoomForLabels)
{
  LasRecipe full;
  constexpr std::size_t longest_record = 65535, length_of_format = 30;
  full.extra.assign (2, std::string (longest_record - length_of_format, 'e'));
  EXPECT_EQ (load ("a.las", lasBytes (full)).las->validate ({label_field}),
             "has no room for a further extra-bytes field; give an OUTPUT.pcd");
  EXPECT_EQ (load ("a.las", lasBytes ({})).las->validate ({label_field}), "");
}

TEST_F (LasFileTest, IsRefusedWhereverItIsCut)
{
  LasRecipe recipe;
  recipe.vlrs = {lasVlr ("someone", 7, "content")};
  recipe.evlrs = {lasVlr<LasHeader::UInt64> ("someone", 9, "behind the points")};
  const std::string whole = lasBytes (recipe);
  EXPECT_EQ (complaintAbout ("a.las", whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE (complaintAbout ("a.las", whole.substr (0, size)), "") << size;
}

TEST_F (LasFileTest, RefusesExtraBytesThatDoNotAddUp)
{
  const auto complaint = [&] (const std::string& descriptions) {
    LasRecipe recipe;
    recipe.extra = {"1234", "5678"}; // four bytes for each point
    recipe.vlrs = {lasVlr ("LASF_Spec", 4, descriptions)};
    return complaintAbout ("a.las", lasBytes (recipe));
  };
  EXPECT_EQ (complaint (extraBytesField ("a", las_float)), "");
  EXPECT_EQ (complaint (extraBytesField ("a", las_undocumented, 4)), "");
  EXPECT_EQ (complaint (extraBytesField ("a", las_pair_of_uint16)), "");
  EXPECT_EQ (
      complaint (extraBytesField ("a", las_double)),
      invalid ("its Extra Bytes VLR describes more bytes than its records have"));
  EXPECT_EQ (complaint (extraBytesField ("a", 31)),
             invalid ("its Extra Bytes VLR has an unknown type, 31"));
  EXPECT_EQ (complaint (extraBytesField ("a", las_float) + "b"),
             invalid ("its Extra Bytes VLR ends within a description"));
  LasRecipe twice;
  twice.vlrs.assign (2, lasVlr ("LASF_Spec", 4, ""));
  EXPECT_EQ (complaintAbout ("a.las", lasBytes (twice)),
             invalid ("it has two Extra Bytes VLRs"));
  twice.vlrs.pop_back();
  twice.evlrs = {lasVlr<LasHeader::UInt64> ("LASF_Spec", 4, "")};
  EXPECT_EQ (complaintAbout ("a.las", lasBytes (twice)),
             invalid ("it has two Extra Bytes VLRs"));
}

TEST_F (LasFileTest, CannotAddToExtraBytesThatAreDescribedBehindItsPoints)
{
  LasRecipe recipe;
  recipe.extra = {"12", "34"};
  recipe.evlrs = {lasVlr<LasHeader::UInt64> (
      "LASF_Spec", 4, extraBytesField ("range", las_uint16))};
  const FileCloud cloud = load ("a.las", lasBytes (recipe));
  EXPECT_EQ (cloud.size(), recipe.points.size());
  EXPECT_EQ (
      cloud.las->validate ({label_field}),
      "describes its Extra Bytes behind its points, where no field can be added; "
      "give an OUTPUT.pcd");
}

TEST_F (LasFileTest, ReadsAndReplacesALabelThatIsDescribedBehindItsPoints)
{
  LasRecipe recipe;
  recipe.extra = {std::string ("\1\0\0\0", 4), std::string ("\2\0\0\0", 4)};
  recipe.evlrs = {lasVlr<LasHeader::UInt64> (
      "LASF_Spec", 4, extraBytesField ("label", las_uint32))};
  const FileCloud cloud = load ("a.las", lasBytes (recipe));
  EXPECT_TRUE (contains (textOf (cloud), "; label 1 2"));
  EXPECT_EQ (cloud.las->validate ({label_field}), "");
  EXPECT_TRUE (
      contains (textOf (load ("b.las", labeled (lasBytes (recipe), {70000, 3}))),
                "; label 70000 3"));
}

TEST_F (LasFileTest, IsCalledInMessagesAsTheFileItWasDecompressedFrom)
{
  LasFile las (folder_.write ("temporary.las", lasBytes ({})), "a.laz");
  const std::string no_labels = complaintOf ([&] { las.forLabels ({}); });
  EXPECT_EQ (no_labels, "a.laz: has no labels; give a file with labels");
  const std::string beyond_end = complaintOf ([&] { las.bytes (0, 1U << 20U); });
  EXPECT_EQ (beyond_end.find ("a.laz: is truncated"), 0u);
}

TEST_F (LasFileTest, IsNotWrittenAsLazWithoutLaszip)
{
  if (hasLaszip())
    GTEST_SKIP() << "LASzip does it";
  LasFile las (folder_.write ("a.las", lasBytes ({})));
  EXPECT_EQ (complaintOf ([&] {
               saveLabeledLas ("b.laz", las, {1, 2});
             }),
             "b.laz: is a .laz, and this build has no LASzip; give a .las");
}

TEST_F (LasFileTest, SaysHowToDecompressLaz)
{
  if (hasLaszip())
    GTEST_SKIP() << "LASzip does it";
  const std::string fix =
      "is compressed (LAZ), and this build has no LASzip; build again with "
      "liblaszip-dev, on Debian 12 with LASzip's source (files.md), or decompress it, "
      "e.g. by laspy[lazrs] of Python";
  LasRecipe recipe;
  recipe.vlrs = {lasVlr ("laszip encoded", 22204, "content")};
  EXPECT_EQ (complaintAbout ("a.las", lasBytes (recipe)), fix);
  std::string las = lasBytes ({});
  for (const std::uint8_t mark_of_compression : {0x80, 0x40}) {
    headerIn (las).format_bits = mark_of_compression | 6; // the point format
    EXPECT_EQ (complaintAbout ("a.las", las), fix);
  }
}
