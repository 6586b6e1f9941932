// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_file.h"

#include <Eigen/Geometry>

#include "cloud_file.h"
#include "inputs.h"
#include "output_file.h"
#include <cli/errors.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <ostream>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

constexpr std::uint64_t field_length = sizeof (std::uint32_t);

/** \brief The values that are read from a record, in the order of the fields. */
struct Point {
  Eigen::Vector3d place;
  float intensity;
  std::uint32_t label;
};

template <typename Visit>
void
forRecords (LasFile& las, Visit&& visit)
{
  constexpr std::uint64_t block = 1U << 14U;
  const std::uint64_t end = las.header.pointsEnd();
  const std::uint64_t length = las.header.record_length;
  for (std::uint64_t at = las.header.points_offset; at < end; at += block * length) {
    const std::string records = las.bytes (at, std::min (end, at + block * length));
    for (std::size_t i = 0; i < records.size(); i += length)
      visit (&records[i]);
  }
}

Eigen::Vector3d
placeIn (const char* record, const LasFile& las)
{
  const auto& point = *reinterpret_cast<const LasPoint*> (record);
  const Eigen::Vector3d raw (point.raw[0], point.raw[1], point.raw[2]);
  return raw.cwiseProduct (las.scale) + las.offset;
}

/** \brief Returns the offset in a record [bytes] of the field with this name and type.
 */
std::optional<std::uint64_t>
placeOf (const LasField& field, const LasFile& las)
{
  for (const LasField& described : las.fields)
    if (described.name == field.name && described.type == field.type)
      return described.place;
  return {};
}

/** \brief Returns the descriptions to append to the Extra Bytes VLR for added fields.
 * Those of bytes that it does not describe yet come first. */
std::string
descriptionsOf (const std::vector<LasField>& added, const LasFile& las)
{
  const std::uint64_t unknown = las.header.record_length - las.fields_end;
  // One description per byte: CloudCompare counts several undocumented bytes as one
  // (LasExtraScalarField::elementSize) and then reads later fields at wrong offsets.
  constexpr std::uint64_t max_single = 64;
  constexpr std::uint64_t longest = 255;
  std::string bytes;
  for (std::uint64_t left = unknown; left > 0;) {
    LasField undocumented;
    undocumented.options =
        std::uint8_t (unknown > max_single ? std::min (left, longest) : 1);
    bytes += descriptionOf (undocumented);
    left -= undocumented.options;
  }
  for (const LasField& field : added)
    bytes += descriptionOf (field);
  return bytes;
}

/** \brief Returns the bytes in front of the points of a copy whose records have further
 * fields. */
std::string
frontWith (const std::vector<LasField>& fields, LasFile& las)
{
  const LasHeader& header = las.header;
  std::string front = las.bytes (0, header.points_offset);
  if (fields.empty())
    return front;
  const std::uint64_t length = fields.size() * field_length;
  const std::string description = descriptionsOf (fields, las);
  LasHeader copy = header;
  copy.record_length = static_cast<std::uint16_t> (header.record_length + length);
  if (las.extra_bytes) {
    const std::uint64_t size = las.extra_bytes->size() + description.size();
    auto& vlr = reinterpret_cast<LasShortVlrHeader&> (front[las.extra_bytes->begin]);
    vlr.length = static_cast<std::uint16_t> (size);
    front.insert (las.extra_bytes->end, description);
  }
  else {
    ++copy.vlr_count;
    front.insert (las.vlrs_end, extraBytesVlr (description, header.minor_version));
  }
  const std::uint64_t end = front.size() + las.size() * copy.record_length;
  las.putHeader (copy, header.pointsEnd(), end, front);
  return front;
}

void
writeWith (const std::vector<LasColumn>& columns, LasFile& las, std::ostream& stream)
{
  std::vector<LasField> added;
  std::vector<std::uint64_t> places;
  std::uint64_t length = las.header.record_length;
  for (const auto& [field, bits] : columns) {
    const std::optional<std::uint64_t> place = placeOf (field, las);
    places.push_back (place.value_or (length));
    if (place)
      continue;
    added.push_back (field);
    length += field_length;
  }
  stream << frontWith (added, las);
  constexpr std::size_t block = 1U << 16U;
  std::string records;
  forRecords (las, [&] (const char* record) {
    const std::size_t begin = records.size();
    records.append (record, las.header.record_length);
    records.resize (begin + length);
    const Eigen::Vector3d place = placeIn (record, las);
    for (std::size_t i = 0; i < columns.size(); ++i)
      reinterpret_cast<LasHeader::Long&> (records[begin + places[i]]) =
          columns[i].second (place);
    if (records.size() < block)
      return;
    stream << records;
    records.clear();
  });
  stream << records;
  las.copyRest (las.header.pointsEnd(), stream);
}

LasHeader
headerOf (const std::vector<LasPoint>& points,
          double scale,
          const Eigen::Vector3d& offset)
{
  LasHeader header{};
  header.signature = {'L', 'A', 'S', 'F'};
  header.major_version = 1;
  header.minor_version = 2;
  std::strcpy (header.software.data(), "pcl_ops");
  header.size = 227;
  header.vlr_count = 1;
  header.record_length = sizeof (LasPoint);
  header.legacy_points = static_cast<std::uint32_t> (points.size());
  header.legacy_points_by_return[0] = header.legacy_points;
  Eigen::AlignedBox<std::int32_t, 3> box;
  for (const LasPoint& point : points)
    box.extend (Eigen::Vector3i (point.raw[0], point.raw[1], point.raw[2]));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index> (axis);
    header.scale.at (axis) = scale;
    header.offset.at (axis) = offset[i];
    header.bounds.at (2 * axis) = box.max()[i] * scale + offset[i];
    header.bounds.at (2 * axis + 1) = box.min()[i] * scale + offset[i];
  }
  return header;
}

} // namespace

pcl::PCLPointCloud2
LasFile::readPoints()
{
  pcl::PCLPointCloud2 cloud;
  for (const char* axis : {"x", "y", "z"})
    addField (axis, PCLPointField::FLOAT64, cloud);
  addField ("intensity", PCLPointField::FLOAT32, cloud);
  const std::optional<std::uint64_t> label = placeOf (label_field, *this);
  if (label)
    addField ("label", PCLPointField::UINT32, cloud);
  cloud.width = static_cast<pcl::uindex_t> (size());
  cloud.height = 1;
  cloud.data.resize (size() * cloud.point_step);
  std::uint8_t* point = cloud.data.data();
  forRecords (*this, [&] (const char* record) {
    const LasHeader::Short intensity =
        reinterpret_cast<const LasPoint*> (record)->intensity;
    Point read{placeIn (record, *this), float (intensity), 0};
    if (label)
      read.label = reinterpret_cast<const LasHeader::Long&> (record[*label]);
    std::memcpy (point, &read, cloud.point_step);
    point += cloud.point_step;
  });
  return cloud;
}

Eigen::Vector3d
LasFile::place (std::uint64_t point)
{
  // Successive points are read in blocks, any other one alone: a jump in the file costs
  // more than reading a point.
  constexpr std::uint64_t most = 4096;
  if (point < first_in_block || point >= first_in_block + points_in_block) {
    const bool is_next = point == first_in_block + points_in_block;
    points_in_block = is_next ? std::min (most, header.pointCount() - point) : 1;
    first_in_block = point;
    const std::uint64_t begin = header.points_offset + point * header.record_length;
    block = bytes (begin, begin + points_in_block * header.record_length);
  }
  return placeIn (&block[(point - first_in_block) * header.record_length], *this);
}

void
LasFile::forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit)
{
  forRecords (*this, [&] (const char* record) { visit (placeIn (record, *this)); });
}

void
LasFile::forLabels (const VisitLabelled& visit)
{
  const std::optional<std::uint64_t> label = placeOf (label_field, *this);
  if (!label)
    throw WorkError (file, "has no labels; give a file with labels");
  forRecords (*this, [&] (const char* record) {
    visit (placeIn (record, *this),
           reinterpret_cast<const LasHeader::Long&> (record[*label]));
  });
}

std::string
LasFile::validate (const std::vector<LasField>& wanted) const
{
  std::vector<LasField> added;
  for (const LasField& field : wanted) {
    if (placeOf (field, *this))
      continue;
    for (const LasField& known : fields)
      if (known.name == field.name)
        return "has an extra-bytes field " + field.name + " that is no " +
               field.type_name + "; rename it or give an OUTPUT.pcd";
    added.push_back (field);
  }
  if (added.empty())
    return "";
  constexpr std::uint64_t max_short = std::numeric_limits<std::uint16_t>::max();
  const std::uint64_t described = extra_bytes ? extra_bytes->size() : 0;
  const std::uint64_t description = descriptionsOf (added, *this).size();
  const std::uint64_t with_vlr = extraBytesVlr ("", 0).size() + description;
  if (described + description > max_short ||
      header.record_length + added.size() * field_length > max_short ||
      header.points_offset + with_vlr > std::numeric_limits<std::uint32_t>::max())
    return "has no room for a further extra-bytes field; give an OUTPUT.pcd";
  return "";
}

bool
isLasName (const std::string& file)
{
  return hasExtension (file, {".las", ".laz"});
}

std::shared_ptr<LasFile>
openLas (const std::string& file)
{
  checkReadable (file, cloudFileKinds());
  auto las = std::make_shared<LasFile> (file);
  if (!las->isCompressed()) {
    las->checkPoints();
    return las;
  }
  const Spool spool (".las", file);
  spool.fill ([&] (std::ostream& stream) { decompressLaz (file, stream); });
  try {
    las = std::make_shared<LasFile> (spool.name());
    las->checkPoints();
    return las;
  }
  catch (const WorkError& error) {
    throw WorkError (file, error.problem);
  }
}

void
saveLasWith (const std::string& file,
             LasFile& las,
             const std::vector<LasColumn>& columns)
{
  const auto write = [&] (std::ostream& stream) { writeWith (columns, las, stream); };
  if (extensionOf (file) != ".laz")
    return writeFile (file, write);
  const Spool spool (".las", file);
  spool.fill (write);
  writeFile (file, [&] (std::ostream& stream) { compressLas (spool.name(), stream); });
}

void
saveLabelledLas (const std::string& file,
                 LasFile& las,
                 const std::vector<std::uint32_t>& labels,
                 const std::vector<float>& distances,
                 const std::vector<std::uint32_t>& planes)
{
  const auto column = [] (const LasField& field, const auto& values) {
    return LasColumn (field, [&values, i = 0U] (const Eigen::Vector3d&) mutable {
      std::uint32_t bits;
      static_assert (sizeof (bits) == sizeof (values[i]));
      std::memcpy (&bits, &values[i++], sizeof (bits));
      return bits;
    });
  };
  std::vector<LasColumn> columns = {column (label_field, labels)};
  if (!distances.empty())
    columns.push_back (column (distance_field, distances));
  if (!planes.empty())
    columns.push_back (column (plane_field, planes));
  saveLasWith (file, las, columns);
}

void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset)
{
  LasHeader header = headerOf (points, scale, offset);
  const std::string vlr =
      extraBytesVlr (descriptionOf (label_field), header.minor_version);
  header.points_offset = static_cast<std::uint32_t> (header.size + vlr.size());
  writeFile (file, [&] (std::ostream& stream) {
    stream.write (reinterpret_cast<const char*> (&header), header.size) << vlr;
    stream.write (reinterpret_cast<const char*> (points.data()),
                  static_cast<std::streamsize> (points.size() * sizeof (LasPoint)));
  });
}

} // namespace pcl_ops::apps
