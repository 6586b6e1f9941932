// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "las_file.h"

#include "cloud_file.h"
#include "laz_file.h"
#include "output_file.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

namespace pcl_ops::apps {

namespace {

using pcl::PCLPointField;

constexpr std::uint64_t field_length = sizeof (std::uint32_t);

template <typename Visit>
void
forRecords (LasFrame& las, Visit&& visit)
{
  constexpr std::uint64_t block = 1U << 14U;
  const std::uint64_t end = las.header.pointsEnd(), length = las.header.record_length;
  for (std::uint64_t at = las.header.points_offset; at < end; at += block * length) {
    const std::string records = las.bytes (at, std::min (end, at + block * length));
    for (std::size_t i = 0; i < records.size(); i += length)
      visit (&records[i]);
  }
}

Eigen::Vector3d
placeOf (const char* record, const LasHeader& header)
{
  constexpr std::size_t length = sizeof (std::int32_t);
  const Eigen::Vector3d raw (fromLittleEndian<std::int32_t> (record),
                             fromLittleEndian<std::int32_t> (record + length),
                             fromLittleEndian<std::int32_t> (record + 2 * length));
  return raw.cwiseProduct (header.scale) + header.offset;
}

/** \brief What is in front of the points where their records have further fields. */
std::string
frontWith (const std::vector<LasField>& fields, LasFrame& las)
{
  const LasHeader& header = las.header;
  std::string front = las.bytes (0, header.points_offset);
  if (fields.empty())
    return front;
  const std::uint64_t length = fields.size() * field_length;
  const std::string description = las.descriptionsOf (fields);
  setNumber (front,
             las_field::record_length,
             static_cast<std::uint16_t> (header.record_length + length));
  if (las.extra_bytes) {
    const LasVlr& vlr = *las.extra_bytes;
    setNumber (front,
               vlr.begin + vlr_length_field,
               static_cast<std::uint16_t> (vlr.size() + description.size()));
    front.insert (vlr.end, description);
  }
  else {
    setNumber (front, las_field::vlr_count, header.vlr_count + 1);
    front.insert (las.vlrs_end, extraBytesVlr (description));
  }
  las.relocate (
      header.pointsEnd(), static_cast<std::int64_t> (length * header.points), front);
  return front;
}

template <typename Number>
void
append (Number number, std::uint8_t*& point)
{
  std::memcpy (point, &number, sizeof (number));
  point += sizeof (number);
}

void
saveWith (const std::string& file, LasFile& las, const std::vector<LasColumn>& columns)
{
  const auto write = [&] (std::ostream& stream) { las.writeWith (columns, stream); };
  if (!isLazName (file))
    return writeFile (file, write);
  const Spool spool (".las", file);
  spool.fill (write);
  writeFile (file, [&] (std::ostream& stream) { compressLas (spool.name(), stream); });
}

constexpr std::uint16_t header_size = 227, record_size = 20, labeled_size = 24;

std::string
headerOf (const std::vector<LasPoint>& points,
          double scale,
          const Eigen::Vector3d& offset,
          std::size_t vlr_size)
{
  constexpr std::size_t version = 24, software = 58;
  std::string bytes = "LASF";
  bytes.resize (header_size, '\0');
  bytes.replace (version, 2, "\1\2");
  bytes.replace (software, 7, "pcl_ops");
  const auto count = static_cast<std::uint32_t> (points.size());
  setNumber (bytes, las_field::header_size, header_size);
  setNumber (bytes,
             las_field::points_offset,
             static_cast<std::uint32_t> (header_size + vlr_size));
  setNumber (bytes, las_field::vlr_count, std::uint32_t (1));
  setNumber (bytes, las_field::record_length, labeled_size);
  setNumber (bytes, las_field::legacy_points, count);
  setNumber (bytes, las_field::legacy_points + sizeof (count), count); // first returns
  Eigen::AlignedBox<std::int32_t, 3> box;
  for (const LasPoint& point : points)
    box.extend (Eigen::Map<const Eigen::Vector3i> (point.raw.data()));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index> (axis);
    setNumber (bytes, las_field::scale + 8 * axis, scale);
    setNumber (bytes, las_field::offset + 8 * axis, offset[i]);
    setNumber (bytes, las_field::bounds + 16 * axis, box.max()[i] * scale + offset[i]);
    setNumber (
        bytes, las_field::bounds + 16 * axis + 8, box.min()[i] * scale + offset[i]);
  }
  return bytes;
}

} // namespace

LasFile::LasFile (const std::string& file) : frame_ (file)
{
  const LasHeader& header = frame_.header;
  if (header.points >
      (frame_.reader.fileSize() - header.points_offset) / header.record_length)
    frame_.reader.failTruncated();
  frame_.checkCount();
  frame_.checkEvlrs();
}

pcl::PCLPointCloud2
LasFile::readPoints()
{
  constexpr std::size_t intensity = 12;
  pcl::PCLPointCloud2 cloud;
  for (const char* axis : {"x", "y", "z"})
    addField (axis, PCLPointField::FLOAT64, cloud);
  addField ("intensity", PCLPointField::FLOAT32, cloud);
  const std::optional<std::uint64_t> label = frame_.placeOf (label_field);
  if (label)
    addField ("label", PCLPointField::UINT32, cloud);
  cloud.width = static_cast<pcl::uindex_t> (frame_.header.points);
  cloud.height = 1;
  cloud.row_step = cloud.point_step * cloud.width;
  cloud.data.resize (frame_.header.points * cloud.point_step);
  std::uint8_t* point = cloud.data.data();
  forRecords (frame_, [&] (const char* record) {
    const Eigen::Vector3d place = placeOf (record, frame_.header);
    for (const double coordinate : place)
      append (coordinate, point);
    append (static_cast<float> (fromLittleEndian<std::uint16_t> (record + intensity)),
            point);
    if (label)
      append (fromLittleEndian<std::uint32_t> (record + *label), point);
  });
  return cloud;
}

Eigen::Vector3d
LasFile::place (std::uint64_t point)
{
  const LasHeader& header = frame_.header;
  const std::uint64_t begin = header.points_offset + point * header.record_length;
  const std::string record = frame_.bytes (begin, begin + 3 * sizeof (std::int32_t));
  return placeOf (record.data(), header);
}

void
LasFile::forPlaces (const std::function<void (const Eigen::Vector3d&)>& visit)
{
  forRecords (frame_,
              [&] (const char* record) { visit (placeOf (record, frame_.header)); });
}

std::string
LasFile::validate (const std::vector<LasField>& fields) const
{
  std::vector<LasField> added;
  for (const LasField& field : fields) {
    if (frame_.placeOf (field))
      continue;
    if (frame_.hasNamed (field))
      return "has an extra-bytes field " + field.name + " that is no " +
             field.type_name + "; rename it or give an OUTPUT.pcd";
    added.push_back (field);
  }
  if (added.empty())
    return "";
  constexpr std::uint64_t max_short = std::numeric_limits<std::uint16_t>::max();
  const std::uint64_t described = frame_.extra_bytes ? frame_.extra_bytes->size() : 0;
  const std::uint64_t description = frame_.descriptionsOf (added).size();
  const std::uint64_t with_vlr = extraBytesVlr ("").size() + description;
  if (described + description > max_short ||
      frame_.header.record_length + added.size() * field_length > max_short ||
      frame_.header.points_offset + with_vlr >
          std::numeric_limits<std::uint32_t>::max())
    return "has no room for a further extra-bytes field; give an OUTPUT.pcd";
  return "";
}

void
LasFile::writeWith (const std::vector<LasColumn>& columns, std::ostream& stream)
{
  std::vector<LasField> added;
  std::vector<std::uint64_t> places;
  std::uint64_t length = frame_.header.record_length;
  for (const auto& [field, bits] : columns) {
    const std::optional<std::uint64_t> place = frame_.placeOf (field);
    places.push_back (place.value_or (length));
    if (place)
      continue;
    added.push_back (field);
    length += field_length;
  }
  stream << frontWith (added, frame_);
  constexpr std::size_t block = 1U << 16U;
  std::string records;
  forRecords (frame_, [&] (const char* record) {
    const std::size_t begin = records.size();
    records.append (record, frame_.header.record_length);
    records.resize (begin + length);
    const Eigen::Vector3d place = placeOf (record, frame_.header);
    for (std::size_t i = 0; i < columns.size(); ++i)
      records.replace (
          begin + places[i], field_length, littleEndian (columns[i].second (place)));
    if (records.size() < block)
      return;
    stream << records;
    records.clear();
  });
  stream << records;
  frame_.copyRest (frame_.header.pointsEnd(), stream);
}

void
saveLabelledLas (const std::string& file, LasFile& las, const LabelOfPlace& label)
{
  saveWith (file, las, {{label_field, label}});
}

void
saveLabelledLas (const std::string& file,
                 LasFile& las,
                 const std::vector<std::uint32_t>& labels,
                 const std::vector<float>& distances)
{
  std::size_t label = 0, distance = 0;
  std::vector<LasColumn> columns = {
      {label_field, [&] (const Eigen::Vector3d&) { return labels[label++]; }}};
  if (!distances.empty())
    columns.push_back ({distance_field, [&] (const Eigen::Vector3d&) {
                          std::uint32_t bits;
                          static_assert (sizeof (bits) == sizeof (distances[0]));
                          std::memcpy (&bits, &distances[distance++], sizeof (bits));
                          return bits;
                        }});
  saveWith (file, las, columns);
}

void
saveLas (const std::string& file,
         const std::vector<LasPoint>& points,
         double scale,
         const Eigen::Vector3d& offset)
{
  const std::string vlr = extraBytesVlr (descriptionOf (label_field));
  writeFile (file, [&] (std::ostream& stream) {
    stream << headerOf (points, scale, offset, vlr.size()) << vlr;
    std::string record (labeled_size, '\0');
    for (const LasPoint& point : points) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        setNumber (record, axis * sizeof (std::int32_t), point.raw[axis]);
      setNumber (record, record_size, point.label);
      stream << record;
    }
  });
}

} // namespace pcl_ops::apps
