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
  FileCloud
  load (const std::string& bytes) const
  {
    return CloudFolder::load ("cloud.las", bytes);
  }

  FileCloud
  load (const LasRecipe& recipe) const
  {
    return load (lasBytes (recipe));
  }

  std::string
  complaintAbout (const std::string& bytes) const
  {
    return CloudFolder::complaintAbout ("cloud.las", bytes);
  }

  /** \brief The file with these labels. */
  std::string
  labelled (const LasRecipe& recipe, const std::vector<std::uint32_t>& labels) const
  {
    saveLabelledLas (folder_ / "labelled.las", *load (recipe).las, labels);
    return contentOf (folder_ / "labelled.las");
  }
};

/** \brief A record with its label. */
std::string
labelledRecord (const LasRecipe& recipe, std::size_t i, std::uint32_t label)
{
  return lasRecord (recipe, i) + littleEndian (label);
}

std::string
invalid (const std::string& reason)
{
  return "is no valid LAS file: " + reason + "; write it again";
}

std::string
changed (std::size_t place, const std::string& bytes, const LasRecipe& recipe = {})
{
  std::string las = lasBytes (recipe);
  put (las, place, bytes);
  return las;
}

} // namespace

TEST_F (LasFileTest, HasTheCoordinatesOfEveryPointFormat)
{
  for (unsigned minor = 2; minor <= 4; ++minor)
    for (unsigned format = 0; format <= 10; ++format) {
      SCOPED_TRACE (std::to_string (minor) + ", format " + std::to_string (format));
      const FileCloud cloud = load (LasRecipe{minor, format});
      ASSERT_EQ (cloud.size(), 2u);
      EXPECT_EQ (valuesOf<double> (cloud, "x")[1], 500000.004);
      EXPECT_EQ (valuesOf<double> (cloud, "y")[1], 5400000.005);
      EXPECT_EQ (valuesOf<double> (cloud, "z")[1], 0.006);
      EXPECT_EQ (valuesOf<float> (cloud, "intensity")[0], 0x0d0c);
    }
}

TEST_F (LasFileTest, KeepsEveryIntegerOfMorePointsThanABlockHas)
{
  LasRecipe recipe;
  constexpr std::int32_t size = 40000, step = 100003;
  recipe.points.clear();
  for (std::int32_t i = -size / 2; i < size / 2; ++i)
    recipe.points.push_back ({step * i, 7 * i, -i});
  const FileCloud cloud = load (recipe);
  ASSERT_EQ (cloud.size(), static_cast<std::size_t> (size));
  const std::vector<double> x = valuesOf<double> (cloud, "x");
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_EQ (std::lround ((x[i] - 500000) / 0.001), recipe.points[i][0]);
}

TEST_F (LasFileTest, IsLabelledWithEveryOtherByteKept)
{
  constexpr std::uint32_t added = 54 + 192;
  for (unsigned minor = 2; minor <= 4; ++minor) {
    SCOPED_TRACE (minor);
    LasRecipe recipe{minor, 3};
    recipe.vlrs = {lasVlr ("someone", 7, "content"),
                   lasVlr ("LASF_Projection", 1, "p")};
    recipe.gap = "between";
    if (minor == 4)
      recipe.evlrs = {lasVlr<std::uint64_t> ("someone", 9, "behind the points")};
    const std::string before = lasBytes (recipe);
    const auto points = lasNumber<std::uint32_t> (before, las_at::points_offset);
    std::string expected = before.substr (0, points);
    put (expected, las_at::points_offset, littleEndian (points + added));
    put (expected, las_at::vlr_count, littleEndian (std::uint32_t (3)));
    put (expected, las_at::record_length, littleEndian (std::uint16_t (34 + 4)));
    expected += labelledRecord (recipe, 0, 70000) + labelledRecord (recipe, 1, 0);
    if (minor == 4) {
      put (expected, las_at::evlr_offset, littleEndian (expected.size() + added));
      expected += recipe.evlrs[0];
    }
    std::string after = labelled (recipe, {70000, 0});
    after.erase (points - recipe.gap.size(), added);
    EXPECT_TRUE (after == expected);
  }
}

TEST_F (LasFileTest, MovesTheWaveformsBehindThePoints)
{
  const LasRecipe recipe{3, 4};
  const std::uint64_t end = lasBytes (recipe).size();
  const std::string las = changed (las_at::waveform_offset, littleEndian (end), recipe);
  saveLabelledLas (folder_ / "out.las", *load (las + "waveforms").las, {1, 2});
  const std::string after = contentOf (folder_ / "out.las");
  EXPECT_EQ (after.substr (lasNumber<std::uint64_t> (after, las_at::waveform_offset)),
             "waveforms");
}

TEST_F (LasFileTest, AddsTheLabelToTheExtraBytesThereAre)
{
  LasRecipe recipe;
  recipe.extra = {"ab123", "cd456"};
  recipe.vlrs = {lasVlr ("LASF_Spec", 4, extraBytesField ("range", 3)),
                 lasVlr ("someone", 7, "content")};
  const std::string after = labelled (recipe, {5, 6});
  const std::size_t vlr = lasHeaderSize (4), fields = vlr + 54;
  EXPECT_EQ (lasNumber<std::uint32_t> (after, las_at::vlr_count), 2u);
  ASSERT_EQ (lasNumber<std::uint16_t> (after, vlr + 20), 5 * 192u);
  EXPECT_EQ (after.substr (fields, 192), extraBytesField ("range", 3));
  for (std::size_t i = 1; i <= 3; ++i)
    EXPECT_EQ (after.substr (fields + i * 192, 192), extraBytesField ("", 0, 1))
        << "what nobody had described, byte by byte, as CloudCompare counts";
  EXPECT_STREQ (&after[fields + 4 * 192 + 4], "label");
  EXPECT_EQ (after.substr (fields + 5 * 192, recipe.vlrs[1].size()), recipe.vlrs[1]);
  EXPECT_EQ (after.substr (lasNumber<std::uint32_t> (after, las_at::points_offset)),
             labelledRecord (recipe, 0, 5) + labelledRecord (recipe, 1, 6));
}

TEST_F (LasFileTest, ReadsAndReplacesTheLabelsItWrote)
{
  const std::string first = labelled (LasRecipe{}, {70000, 3});
  const FileCloud cloud = load (first);
  EXPECT_EQ (valuesOf<std::uint32_t> (cloud, "label")[0], 70000u);
  EXPECT_EQ (valuesOf<std::uint32_t> (cloud, "label")[1], 3u);
  EXPECT_FALSE (hasField (load (LasRecipe{}), "label"));
  saveLabelledLas (folder_ / "again.las", *load (first).las, {3, 4});
  EXPECT_TRUE (contentOf (folder_ / "again.las") == labelled (LasRecipe{}, {3, 4}));
}

TEST_F (LasFileTest, SaysThatItHasNoRoomForLabels)
{
  LasRecipe full;
  full.extra.assign (2, std::string (65535 - lasFormatLength (6), 'e'));
  EXPECT_EQ (load (full).las->validate ({label_field}),
             "has no room for a further extra-bytes field; give an OUTPUT.pcd");
  EXPECT_EQ (load (LasRecipe{}).las->validate ({label_field}), "");
}

TEST_F (LasFileTest, IsRefusedWhereverItIsCut)
{
  LasRecipe recipe;
  recipe.vlrs = {lasVlr ("someone", 7, "content")};
  recipe.evlrs = {lasVlr<std::uint64_t> ("someone", 9, "behind the points")};
  const std::string whole = lasBytes (recipe);
  EXPECT_EQ (complaintAbout (whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE (complaintAbout (whole.substr (0, size)), "") << size;
}

TEST_F (LasFileTest, RefusesExtraBytesThatDoNotAddUp)
{
  const auto complaint = [&] (const std::string& descriptions) {
    LasRecipe recipe;
    recipe.extra = {"1234", "5678"};
    recipe.vlrs = {lasVlr ("LASF_Spec", 4, descriptions)};
    return complaintAbout (lasBytes (recipe));
  };
  EXPECT_EQ (complaint (extraBytesField ("a", 9)), "");
  EXPECT_EQ (complaint (extraBytesField ("a", 0, 4)), "");
  EXPECT_EQ (complaint (extraBytesField ("a", 13)), "") << "a pair of 16 bits";
  EXPECT_EQ (
      complaint (extraBytesField ("a", 10)),
      invalid ("its Extra Bytes VLR describes more bytes than its records have"));
  EXPECT_EQ (complaint (extraBytesField ("a", 31)),
             invalid ("its Extra Bytes VLR has an unknown type, 31"));
  EXPECT_EQ (complaint (extraBytesField ("a", 9) + "b"),
             invalid ("its Extra Bytes VLR ends within a description"));
  LasRecipe twice;
  twice.vlrs.assign (2, lasVlr ("LASF_Spec", 4, ""));
  EXPECT_EQ (complaintAbout (lasBytes (twice)),
             invalid ("it has two Extra Bytes VLRs"));
  LasRecipe behind;
  behind.evlrs = {lasVlr<std::uint64_t> ("LASF_Spec", 4, "")};
  EXPECT_EQ (complaintAbout (lasBytes (behind)),
             invalid ("its Extra Bytes are described behind its points"));
}

TEST_F (LasFileTest, SaysHowToDecompressLaz)
{
  if (hasLaszip())
    GTEST_SKIP() << "LASzip does it";
  const std::string fix = "is compressed (LAZ); decompress it, e.g. by laszip or pdal";
  EXPECT_EQ (complaintAbout (changed (las_at::format, "\x86")), fix);
  EXPECT_EQ (complaintAbout (changed (las_at::format, "\x46")), fix);
  LasRecipe recipe;
  recipe.vlrs = {lasVlr ("laszip encoded", 22204, "content")};
  EXPECT_EQ (complaintAbout (lasBytes (recipe)), fix);
}
