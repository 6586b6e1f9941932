// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/PCLPointField.h>

#include "cloud_formats.h"
#include "file_reader.h"
#include "point_rows.h"

namespace pcl_ops::apps {

namespace {

struct OffHeader {
  /** \brief Whether vertices have normals and colors. */
  bool has_normals = false, has_colors = false;
  std::uint64_t vertex_count = 0;
};

/** \brief Reads the header: the word OFF, with letters in front of it that tell what
 * vertices have besides coordinates, and the numbers of vertices, faces and edges, in
 * the same line or in the next one. */
OffHeader
readOffHeader (FileReader& reader)
{
  reader.skipByteOrderMark();
  if (!reader.nextWords())
    reader.failEmpty();
  const std::string first_word (reader.word (0));
  const std::string key = "OFF";
  const std::size_t key_begin = first_word.find (key);
  const std::string letters = first_word.substr (0, key_begin);
  if (key_begin == std::string::npos ||
      letters.find_first_not_of ("CN") != std::string::npos)
    reader.fail ("its first line is not OFF, COFF, NOFF or CNOFF");
  OffHeader header;
  header.has_normals = letters.find ('N') != std::string::npos;
  header.has_colors = letters.find ('C') != std::string::npos;
  // ModelNet has no blank between OFF and the number of vertices.
  std::string counts = first_word.substr (key_begin + key.size());
  for (std::size_t i = 1; i < reader.wordCount(); ++i)
    counts += " " + std::string (reader.word (i));
  reader.setLine (counts, ' ');
  if (reader.wordCount() == 0 && !reader.nextWords())
    reader.failTruncated();
  header.vertex_count =
      reader.parseCount ("its number of vertices", std::string (reader.word (0)));
  if (header.vertex_count == 0)
    reader.failEmpty();
  return header;
}

/** \brief Returns names for the columns behind the coordinates of a vertex: three for
 * the normal, and for the color up to four, as many as the other numbers need.
 * \param[in] column_count number of numbers of a vertex, with its coordinates */
Words
furtherNames (const OffHeader& header, std::size_t column_count)
{
  constexpr std::size_t coordinates = 3;
  Words names;
  if (header.has_normals)
    names = {"normal_x", "normal_y", "normal_z"};
  if (header.has_colors)
    for (const char* color : {"r", "g", "b", "a"})
      if (coordinates + names.size() < column_count)
        names.emplace_back (color);
  return names;
}

} // namespace

FileCloud
readOff (const std::string& file)
{
  FileReader reader (file, "OFF");
  const OffHeader header = readOffHeader (reader);
  PointRows rows (reader);
  while (rows.size() < header.vertex_count) {
    if (!reader.nextWords())
      reader.failTruncated();
    if (!rows.hasColumns())
      rows.addColumnsOfLine (furtherNames (header, reader.wordCount()));
    rows.addPoint();
  }
  return {rows.take()};
}

FileCloud
readObj (const std::string& file)
{
  FileReader reader (file, "OBJ");
  reader.skipByteOrderMark();
  PointRows rows (reader);
  while (reader.nextWords()) {
    if (reader.word (0) != "v")
      continue;
    reader.dropFirstWord();
    if (!rows.hasColumns()) {
      const Words color = {"r", "g", "b"};
      const Words weight = {"w"};
      constexpr std::size_t words_with_weight = 4; // x, y, z, w
      const bool has_weight = reader.wordCount() == words_with_weight;
      rows.addColumnsOfLine (has_weight ? weight : color);
    }
    rows.addPoint();
  }
  return {rows.take()};
}

} // namespace pcl_ops::apps
