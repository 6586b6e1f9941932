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

/** \brief Number of bytes of each field that is added: \ref NextFieldValue returns 32
 * bits. */
constexpr std::uint64_t field_length = sizeof (std::uint32_t);

constexpr std::uint64_t max_uint16 = std::numeric_limits<std::uint16_t>::max();
constexpr std::uint64_t max_uint32 = std::numeric_limits<std::uint32_t>::max();

/** \brief A point of the cloud of \ref LasFile::readPoints, in its byte layout. In a
 * cloud without labels a point ends in front of the label. */
struct PackedPoint {
  Eigen::Vector3d position;
  float intensity;
  std::uint32_t label;
};

/** \brief Calls \p visit with a pointer to each point record, in the order of the
 * points. Only a block of records is in memory at a time. */
template <typename Visit>
void
forRecords (LasFile& las, Visit&& visit)
{
  // 0.3 to 1.1 MB of records without extra bytes; chosen by hand.
  constexpr std::uint64_t records_in_block = 1U << 14U;
  const std::uint64_t record_length = las.header.record_length;
  const std::uint64_t block_length = records_in_block * record_length;
  const std::uint64_t end = las.header.pointsEnd();
  for (std::uint64_t begin = las.header.points_offset; begin < end;
       begin += block_length) {
    const std::string records = las.bytes (begin, std::min (end, begin + block_length));
    for (std::size_t i = 0; i < records.size(); i += record_length)
      visit (&records[i]);
  }
}

Eigen::Vector3d
positionIn (const char* record, const LasFile& las)
{
  // Records of all formats begin with the coordinates, and only these are read.
  const auto& point = *reinterpret_cast<const LasPoint*> (record);
  const Eigen::Vector3d raw (point.raw[0], point.raw[1], point.raw[2]);
  return raw.cwiseProduct (las.coordinate_scale) + las.coordinate_offset;
}

/** \brief Returns the offset in a record [bytes] of the field of a file that has the
 * name and the type of \p field; nothing if the file has no such field. */
std::optional<std::uint64_t>
offsetOf (const LasField& field, const LasFile& las)
{
  for (const LasField& described : las.fields)
    if (described.name == field.name && described.type == field.type)
      return described.offset;
  return {};
}

/** \brief Returns the descriptions to append to the Extra Bytes VLR for added fields.
 * Descriptions of bytes that the VLR does not describe yet come first. */
std::string
descriptionsOf (const std::vector<LasField>& added, const LasFile& las)
{
  // One description per byte: CloudCompare counts several undocumented bytes as one
  // (LasExtraScalarField::elementSize) and then reads later fields at wrong offsets.
  // More than 64 bytes get as few descriptions as possible, as each takes 192 bytes.
  constexpr std::uint64_t max_described_one_by_one = 64;
  constexpr std::uint64_t max_bytes_of_description =
      std::numeric_limits<std::uint8_t>::max();
  const std::uint64_t undescribed = las.header.record_length - las.fields_end;
  const std::uint64_t bytes_of_each =
      undescribed > max_described_one_by_one ? max_bytes_of_description : 1;
  std::string descriptions;
  for (std::uint64_t remaining = undescribed; remaining > 0;) {
    LasField undocumented;
    undocumented.options = std::uint8_t (std::min (remaining, bytes_of_each));
    descriptions += descriptionOf (undocumented);
    remaining -= undocumented.options;
  }
  for (const LasField& field : added)
    descriptions += descriptionOf (field);
  return descriptions;
}

/** \brief Returns all bytes in front of the points of a copy of a file. In the copy the
 * added fields are at the end of each record. */
std::string
frontWith (const std::vector<LasField>& added, LasFile& las)
{
  const LasHeader& header = las.header;
  std::string front = las.bytes (0, header.points_offset);
  if (added.empty())
    return front;
  const std::uint64_t added_length = added.size() * field_length;
  const std::string descriptions = descriptionsOf (added, las);
  LasHeader copy_header = header;
  copy_header.record_length =
      static_cast<std::uint16_t> (header.record_length + added_length);
  if (las.extra_bytes) {
    const std::uint64_t size = las.extra_bytes->contentSize() + descriptions.size();
    auto& vlr = reinterpret_cast<LasStandardVlrHeader&> (front[las.extra_bytes->begin]);
    vlr.content_length = static_cast<std::uint16_t> (size);
    front.insert (las.extra_bytes->end, descriptions);
  }
  else {
    ++copy_header.vlr_count;
    front.insert (las.vlrs_end, extraBytesVlr (descriptions, header.minor_version));
  }
  const std::uint64_t copy_points_end =
      front.size() + las.size() * copy_header.record_length;
  las.replaceHeader (copy_header, header.pointsEnd(), copy_points_end, front);
  return front;
}

/** \brief Writes a copy of a file with \p columns (\ref saveLasWith), uncompressed. */
void
writeWith (const std::vector<LasColumn>& columns, LasFile& las, std::ostream& stream)
{
  std::vector<LasField> added;
  std::vector<std::uint64_t> offsets; // of each column, in a record of the copy
  std::uint64_t copy_record_length = las.header.record_length;
  for (const LasColumn& column : columns) {
    const std::optional<std::uint64_t> known_offset = offsetOf (column.field, las);
    offsets.push_back (known_offset.value_or (copy_record_length));
    if (known_offset)
      continue;
    added.push_back (column.field);
    copy_record_length += field_length;
  }
  stream << frontWith (added, las);
  constexpr std::size_t buffer_size = 1U << 16U; // [bytes]
  std::string records;
  forRecords (las, [&] (const char* record) {
    const std::size_t begin = records.size();
    records.append (record, las.header.record_length);
    records.resize (begin + copy_record_length);
    const Eigen::Vector3d position = positionIn (record, las);
    for (std::size_t i = 0; i < columns.size(); ++i)
      reinterpret_cast<LasHeader::UInt32&> (records[begin + offsets[i]]) =
          columns[i].next_value (position);
    if (records.size() < buffer_size)
      return;
    stream << records;
    records.clear();
  });
  stream << records;
  las.copyFrom (las.header.pointsEnd(), stream);
}

/** \brief Returns the header of \ref saveLas, in which the offset of the points is not
 * set. */
LasHeader
headerOf (const std::vector<LasPoint>& points,
          double scale,
          const Eigen::Vector3d& offset)
{
  LasHeader header{};
  header.signature = {'L', 'A', 'S', 'F'};
  header.major_version = 1;
  header.minor_version = 2;
  std::strcpy (header.generating_software.data(), "pcl_ops");
  header.header_size = las_1_2_header_size;
  header.vlr_count = 1;
  header.record_length = sizeof (LasPoint);
  header.legacy_point_count = static_cast<std::uint32_t> (points.size());
  header.legacy_point_counts_by_return[0] = header.legacy_point_count;
  Eigen::AlignedBox<std::int32_t, 3> raw_box;
  for (const LasPoint& point : points)
    raw_box.extend (Eigen::Vector3i (point.raw[0], point.raw[1], point.raw[2]));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index> (axis);
    header.scale.at (axis) = scale;
    header.offset.at (axis) = offset[i];
    header.bounds.at (2 * axis) = raw_box.max()[i] * scale + offset[i];
    header.bounds.at (2 * axis + 1) = raw_box.min()[i] * scale + offset[i];
  }
  return header;
}

} // namespace

pcl::PCLPointCloud2
LasFile::readPoints()
{
  pcl::PCLPointCloud2 cloud;
  for (const char* coordinate : {"x", "y", "z"})
    addField (coordinate, PCLPointField::FLOAT64, cloud);
  addField ("intensity", PCLPointField::FLOAT32, cloud);
  const std::optional<std::uint64_t> label_offset = offsetOf (label_field, *this);
  if (label_offset)
    addField ("label", PCLPointField::UINT32, cloud);
  cloud.width = static_cast<pcl::uindex_t> (size());
  cloud.height = 1;
  cloud.data.resize (size() * cloud.point_step);
  std::uint8_t* out = cloud.data.data();
  forRecords (*this, [&] (const char* record) {
    const LasHeader::UInt16 intensity =
        reinterpret_cast<const LasPoint*> (record)->intensity;
    PackedPoint point{positionIn (record, *this), float (intensity), 0};
    if (label_offset)
      point.label = reinterpret_cast<const LasHeader::UInt32&> (record[*label_offset]);
    std::memcpy (out, &point, cloud.point_step);
    out += cloud.point_step;
  });
  return cloud;
}

Eigen::Vector3d
LasFile::position (std::uint64_t point)
{
  // Points asked for one after the other are read in blocks, as each read costs a jump
  // in the file. Any other point is read alone, as its successors may not be asked for.
  constexpr std::uint64_t max_in_block = 4096; // chosen by hand
  const std::uint64_t block_end = first_in_block + points_in_block;
  if (point < first_in_block || point >= block_end) {
    const bool is_next = point == block_end; // the first point is, too
    points_in_block = is_next ? std::min (max_in_block, size() - point) : 1;
    first_in_block = point;
    const std::uint64_t begin = header.points_offset + point * header.record_length;
    block = bytes (begin, begin + points_in_block * header.record_length);
  }
  return positionIn (&block[(point - first_in_block) * header.record_length], *this);
}

void
LasFile::forPositions (const std::function<void (const Eigen::Vector3d&)>& visit)
{
  forRecords (*this, [&] (const char* record) { visit (positionIn (record, *this)); });
}

void
LasFile::forLabels (const VisitLabeledPosition& visit)
{
  const std::optional<std::uint64_t> label_offset = offsetOf (label_field, *this);
  if (!label_offset)
    throw WorkError (file, "has no labels; give a file with labels");
  forRecords (*this, [&] (const char* record) {
    visit (positionIn (record, *this),
           reinterpret_cast<const LasHeader::UInt32&> (record[*label_offset]));
  });
}

std::string
LasFile::validate (const std::vector<LasField>& wanted) const
{
  std::vector<LasField> added;
  for (const LasField& field : wanted) {
    if (offsetOf (field, *this))
      continue;
    for (const LasField& described : fields)
      if (described.name == field.name)
        return "has an extra-bytes field " + field.name + " that is no " +
               field.type_name + "; rename it or give an OUTPUT.pcd";
    added.push_back (field);
  }
  if (added.empty())
    return "";
  if (has_extra_bytes_evlr)
    return "describes its Extra Bytes behind its points, where no field can be added; "
           "give an OUTPUT.pcd";
  const std::uint64_t content_size = extra_bytes ? extra_bytes->contentSize() : 0;
  const std::uint64_t added_size = descriptionsOf (added, *this).size();
  const std::uint64_t added_with_vlr = extraBytesVlr ("", 0).size() + added_size;
  const bool is_vlr_too_long = content_size + added_size > max_uint16;
  const bool is_record_too_long =
      header.record_length + added.size() * field_length > max_uint16;
  const bool are_points_too_far = header.points_offset + added_with_vlr > max_uint32;
  if (is_vlr_too_long || is_record_too_long || are_points_too_far)
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
  const TemporaryFile temporary (".las", file);
  temporary.fill ([&] (std::ostream& stream) { decompressLaz (file, stream); });
  las = std::make_shared<LasFile> (temporary.name(), file);
  las->checkPoints();
  return las;
}

void
saveLasWith (const std::string& file,
             LasFile& las,
             const std::vector<LasColumn>& columns)
{
  const auto write = [&] (std::ostream& stream) { writeWith (columns, las, stream); };
  if (extensionOf (file) != ".laz")
    return writeFile (file, write);
  if (!hasLaszip())
    throw WorkError (file, "is a .laz, and this build has no LASzip; give a .las");
  const TemporaryFile temporary (".las", file);
  temporary.fill (write);
  writeFile (file,
             [&] (std::ostream& stream) { compressLas (temporary.name(), stream); });
}

void
saveLabeledLas (const std::string& file,
                LasFile& las,
                const std::vector<std::uint32_t>& labels,
                const std::vector<float>& distances,
                const std::vector<std::uint32_t>& planes)
{
  const auto column = [] (const LasField& field, const auto& values) {
    return LasColumn{field, [&values, i = 0U] (const Eigen::Vector3d&) mutable {
                       std::uint32_t bits;
                       static_assert (sizeof (bits) == sizeof (values[i]));
                       std::memcpy (&bits, &values[i++], sizeof (bits));
                       return bits;
                     }};
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
  header.points_offset = static_cast<std::uint32_t> (header.header_size + vlr.size());
  writeFile (file, [&] (std::ostream& stream) {
    stream.write (reinterpret_cast<const char*> (&header), header.header_size) << vlr;
    stream.write (reinterpret_cast<const char*> (points.data()),
                  static_cast<std::streamsize> (points.size() * sizeof (LasPoint)));
  });
}

} // namespace pcl_ops::apps
