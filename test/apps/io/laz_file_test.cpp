// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/cloud_file.h>
#include <io/las_file.h>
#include <laszip/laszip_api.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

using namespace pcl_ops::apps;

namespace {

/** \brief Compresses a LAS by LASzip itself, as other programs do.
 * \param[in] las,laz paths of the LAS and of the LAZ that is written */
void
compressByLaszip (const std::string& las, const std::string& laz)
{
  laszip_POINTER reader = nullptr, writer = nullptr;
  laszip_BOOL is_compressed = 0;
  laszip_header* header = nullptr;
  laszip_point* point = nullptr;
  ASSERT_EQ (laszip_create (&reader), 0);
  ASSERT_EQ (laszip_create (&writer), 0);
  ASSERT_EQ (laszip_open_reader (reader, las.c_str(), &is_compressed), 0);
  laszip_get_header_pointer (reader, &header);
  laszip_get_point_pointer (reader, &point);
  ASSERT_EQ (laszip_set_header (writer, header), 0);
  constexpr laszip_BOOL compresses = 1;
  ASSERT_EQ (laszip_open_writer (writer, laz.c_str(), compresses), 0);
  const std::uint64_t points = header->number_of_point_records != 0
                                   ? header->number_of_point_records
                                   : header->extended_number_of_point_records;
  for (std::uint64_t i = 0; i < points; ++i) {
    ASSERT_EQ (laszip_read_point (reader), 0);
    ASSERT_EQ (laszip_set_point (writer, point), 0);
    ASSERT_EQ (laszip_write_point (writer), 0);
  }
  ASSERT_EQ (laszip_close_writer (writer), 0);
  laszip_close_reader (reader);
  laszip_destroy (writer);
  laszip_destroy (reader);
}

/** \brief A recipe with everything that a LAS can have beside its points. */
LasRecipe
recipeWithAll (std::uint8_t minor, std::uint8_t format)
{
  LasRecipe recipe{minor, format};
  recipe.extra = {"ab1", "cd2"}; // for each point two bytes that are described, and one
  recipe.vlrs = {lasVlr ("LASF_Spec", 4, extraBytesField ("range", las_uint16)),
                 lasVlr ("someone", 7, "content")};
  recipe.gap = "between";
  if (minor == 4)
    recipe.evlrs = {lasVlr<LasHeader::UInt64> ("someone", 9, "behind the points")};
  return recipe;
}

class LazFileTest : public CloudFolder {
protected:
  /** \brief Writes a LAS and returns its path. */
  std::string
  write (const LasRecipe& recipe) const
  {
    return folder_.write ("in.las", lasBytes (recipe));
  }

  /** \brief Writes a recipe as a LAZ and returns its path. */
  std::string
  compressed (const LasRecipe& recipe) const
  {
    std::ofstream stream (folder_ / "our.laz", std::ios::binary);
    compressLas (write (recipe), stream);
    return folder_ / "our.laz";
  }

  /** \brief The bytes of the LAS that a LAZ decompresses to. */
  std::string
  decompressed (const std::string& laz) const
  {
    {
      std::ofstream stream (folder_ / "again.las", std::ios::binary);
      decompressLaz (laz, stream);
    }
    return contentOf (folder_ / "again.las");
  }

  /** \brief The error message of loading the bytes of a LAZ; empty if they load as two
   * points, other_number if as another number of points. */
  std::string
  complaintAboutBytes (const std::string& bytes) const
  {
    try {
      return load ("bad.laz", bytes).size() == 2 ? "" : other_number;
    }
    catch (const std::exception& error) {
      return error.what();
    }
  }

  static constexpr const char* other_number = "has not two points";
};

} // namespace

TEST_F (LazFileTest, HasThePointsThatLaszipCompressedOfEveryPointFormat)
{
  for (std::uint8_t format = 0; format <= 10; ++format) {
    SCOPED_TRACE (int (format));
    LasRecipe recipe{4, format};
    recipe.extra = {"ab1", "cd2"};
    recipe.vlrs = {lasVlr ("LASF_Spec", 4, extraBytesField ("range", las_uint16))};
    const std::string las = write (recipe);
    compressByLaszip (las, folder_ / "laszip.laz");
    ASSERT_TRUE (LasFile (folder_ / "laszip.laz").isCompressed());
    EXPECT_TRUE (loadCloud (folder_ / "laszip.laz").points.data ==
                 loadCloud (las).points.data);
    std::string again = decompressed (folder_ / "laszip.laz");
    EXPECT_EQ (again.substr (headerIn (again).points_offset),
               lasRecord (recipe, 0) + lasRecord (recipe, 1));
  }
}

TEST_F (LazFileTest, DecompressesToEveryByteThereWas)
{
  for (std::uint8_t minor = 2; minor <= 4; ++minor)
    for (std::uint8_t format = 0; format <= 10; ++format) {
      SCOPED_TRACE (std::to_string (minor) + ", format " + std::to_string (format));
      const LasRecipe recipe = recipeWithAll (minor, format);
      EXPECT_TRUE (decompressed (compressed (recipe)) == lasBytes (recipe));
    }
}

TEST_F (LazFileTest, IsSmallerThanTheLasOfManyPoints)
{
  LasRecipe recipe;
  constexpr std::int32_t size = 60000; // a chunk of LASzip has 50,000
  recipe.points.clear();
  for (std::int32_t i = 0; i < size; ++i)
    recipe.points.push_back ({i, 7 * i, -i});
  const std::string laz = compressed (recipe), las = lasBytes (recipe);
  EXPECT_LT (contentOf (laz).size(), las.size() / 2);
  EXPECT_TRUE (decompressed (laz) == las);
}

TEST_F (LazFileTest, IsLabeledAsTheLasIs)
{
  const LasRecipe recipe = recipeWithAll (4, 6);
  saveLabeledLas (folder_ / "a.las", *loadCloud (write (recipe)).las, {1, 2});
  saveLabeledLas (folder_ / "b.laz", *loadCloud (write (recipe)).las, {1, 2});
  saveLabeledLas (folder_ / "c.las", *loadCloud (compressed (recipe)).las, {1, 2});
  ASSERT_TRUE (LasFile (folder_ / "b.laz").isCompressed());
  EXPECT_TRUE (decompressed (folder_ / "b.laz") == contentOf (folder_ / "a.las"));
  EXPECT_TRUE (contentOf (folder_ / "c.las") == contentOf (folder_ / "a.las"));
}

TEST_F (LazFileTest, IsKnownByItsContentNotByItsName)
{
  const std::string laz = contentOf (compressed (LasRecipe{}));
  const auto points = loadCloud (write (LasRecipe{})).points.data;
  EXPECT_TRUE (loadCloud (folder_.write ("laz.las", laz)).points.data == points);
  const std::string las = folder_.write ("las.laz", lasBytes (LasRecipe{}));
  EXPECT_TRUE (loadCloud (las).points.data == points);
}

TEST_F (LazFileTest, IsNamedInMessagesInsteadOfItsTemporaryCopy)
{
  const std::string laz = compressed (LasRecipe{});
  const std::shared_ptr<LasFile> las = openLas (laz);
  const std::string no_labels = complaintOf ([&] { las->forLabels ({}); });
  EXPECT_EQ (no_labels.substr (0, laz.size() + 2), laz + ": ");
  const std::string beyond_end = complaintOf ([&] { las->bytes (0, 1U << 20U); });
  EXPECT_EQ (beyond_end.substr (0, laz.size() + 2), laz + ": ");
}

TEST_F (LazFileTest, IsRefusedWhereverItIsCut)
{
  const std::string whole = contentOf (compressed (recipeWithAll (4, 6)));
  EXPECT_EQ (complaintAboutBytes (whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE (complaintAboutBytes (whole.substr (0, size)), "") << size;
}

TEST_F (LazFileTest, IsRefusedOrHasAllPointsWhateverByteOfThemIsDamaged)
{
  for (const std::uint8_t format : {3, 7}) {
    std::string whole = contentOf (compressed (recipeWithAll (4, format)));
    const std::size_t begin_of_points = headerIn (whole).points_offset;
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (const char flipped : {'\x01', '\x80', '\xff'}) {
        std::string damaged = whole;
        damaged[i] = static_cast<char> (damaged[i] ^ flipped);
        const std::string complaint = complaintAboutBytes (damaged);
        // A damaged header may promise another number: loading it must only end.
        EXPECT_TRUE (i < begin_of_points || complaint != other_number) << i;
      }
  }
}
