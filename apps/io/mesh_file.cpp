// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/PCLPointField.h>

#include "cloud_formats.h"
#include "header_reader.h"
#include "point_rows.h"

namespace pcl_ops::apps {

namespace {

struct OffHeader {
  bool has_normals = false, has_colors = false;
  std::uint64_t vertices = 0;
};

/** \brief Reads the word OFF, with letters in front of it that tell what vertices have
 * besides coordinates. The numbers of vertices, faces and edges follow it or are in the
 * next line. */
OffHeader
readOffHeader (HeaderReader& reader)
{
  reader.skipMark();
  if (!reader.nextWords())
    reader.failEmpty();
  const std::string first (reader.word (0));
  const std::size_t place = first.find ("OFF");
  const std::string letters = first.substr (0, place);
  if (place == std::string::npos ||
      letters.find_first_not_of ("CN") != std::string::npos)
    reader.fail ("its first line is not OFF, COFF, NOFF or CNOFF");
  OffHeader header;
  header.has_normals = letters.find ('N') != std::string::npos;
  header.has_colors = letters.find ('C') != std::string::npos;
  std::string counts = first.substr (place + 3); // ModelNet has no blank there
  for (std::size_t i = 1; i < reader.wordCount(); ++i)
    counts += " " + std::string (reader.word (i));
  reader.takeNumbers (counts, ' ');
  if (reader.wordCount() == 0 && !reader.nextWords())
    reader.failTruncated();
  header.vertices =
      reader.count ("its number of vertices", std::string (reader.word (0)));
  if (header.vertices == 0)
    reader.failEmpty();
  return header;
}

/** \brief Returns names for the columns behind the coordinates of a vertex with this
 * many numbers. */
Words
furtherNames (const OffHeader& header, std::size_t numbers)
{
  Words names;
  if (header.has_normals)
    names = {"normal_x", "normal_y", "normal_z"};
  if (header.has_colors)
    for (const char* color : {"r", "g", "b", "a"})
      if (names.size() + 3 < numbers)
        names.emplace_back (color);
  return names;
}

} // namespace

FileCloud
readOff (const std::string& file)
{
  HeaderReader reader (file, "OFF");
  const OffHeader header = readOffHeader (reader);
  PointRows rows (reader);
  while (rows.size() < header.vertices) {
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
  HeaderReader reader (file, "OBJ");
  reader.skipMark();
  PointRows rows (reader);
  while (reader.nextWords()) {
    if (reader.word (0) != "v")
      continue;
    reader.dropWord();
    const Words color = {"r", "g", "b"};
    const Words weight = {"w"};
    if (!rows.hasColumns())
      rows.addColumnsOfLine (reader.wordCount() == 4 ? weight : color);
    rows.addPoint();
  }
  return {rows.take()};
}

} // namespace pcl_ops::apps
