// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geopackage.h"

#include <stdexcept>

#ifdef PCL_OPS_WITH_SQLITE

#include <boost/endian/conversion.hpp>
#include <boost/format.hpp>

#include <Eigen/Geometry>

#include <geopackage_tables.h>
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include <cstring>
#include <map>
#include <new>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

/** \brief The database is in memory, so each error of SQLite is taken for a lack of it.
 * \throws std::bad_alloc if the code is not the expected one */
void
checkMemory (int code, int expected = SQLITE_OK)
{
  if (code != expected)
    throw std::bad_alloc();
}

class Database {
public:
  Database() { checkMemory (sqlite3_open (":memory:", &handle)); }
  ~Database() { sqlite3_close (handle); }
  Database (const Database&) = delete;
  Database&
  operator= (const Database&) = delete;

  void
  run (const std::string& sql)
  {
    checkMemory (sqlite3_exec (handle, sql.c_str(), nullptr, nullptr, nullptr));
  }

  std::string
  bytes ()
  {
    sqlite3_int64 size = 0;
    unsigned char* const data = sqlite3_serialize (handle, "main", &size, 0);
    if (data == nullptr)
      throw std::bad_alloc();
    std::string copy (reinterpret_cast<const char*> (data),
                      static_cast<std::size_t> (size));
    sqlite3_free (data);
    return copy;
  }

  sqlite3* handle = nullptr;
};

/** \brief A prepared INSERT statement that is run once per row. */
class Insertion {
public:
  Insertion (Database& database, const std::string& sql)
  {
    checkMemory (
        sqlite3_prepare_v2 (database.handle, sql.c_str(), -1, &statement_, nullptr));
  }
  ~Insertion() { sqlite3_finalize (statement_); }
  Insertion (const Insertion&) = delete;
  Insertion&
  operator= (const Insertion&) = delete;

  /** \brief Sets the next value of the row. */
  void
  add (const Json& value)
  {
    ++column_;
    if (value.is_number_integer())
      checkMemory (sqlite3_bind_int64 (statement_, column_, value.get<std::int64_t>()));
    else if (value.is_number())
      checkMemory (sqlite3_bind_double (statement_, column_, value.get<double>()));
    else if (value.is_string()) {
      const auto text = value.get<std::string>();
      checkMemory (
          sqlite3_bind_text (statement_, column_, text.c_str(), -1, SQLITE_TRANSIENT));
    }
    else
      checkMemory (sqlite3_bind_null (statement_, column_));
  }

  void
  addBlob (const std::string& bytes)
  {
    ++column_;
    if (bytes.empty())
      checkMemory (sqlite3_bind_null (statement_, column_));
    else
      checkMemory (sqlite3_bind_blob64 (
          statement_, column_, bytes.data(), bytes.size(), SQLITE_TRANSIENT));
  }

  void
  run ()
  {
    checkMemory (sqlite3_step (statement_), SQLITE_DONE);
    checkMemory (sqlite3_reset (statement_));
    column_ = 0;
  }

private:
  sqlite3_stmt* statement_ = nullptr;
  int column_ = 0;
};

template <typename Number>
void
append (Number number, std::string& bytes)
{
  boost::endian::native_to_little_inplace (number);
  bytes.append (reinterpret_cast<const char*> (&number), sizeof number);
}

void
append (double number, std::string& bytes)
{
  std::uint64_t bits;
  std::memcpy (&bits, &number, sizeof bits);
  append (bits, bytes);
}

/** \brief A geometry of GeoJSON as well-known binary (ISO 13249-3), and its bounding
 * box in x and y. */
class Wkb {
public:
  explicit Wkb (const Json& geometry)
  {
    write (geometry.at ("type").get<std::string>(), geometry.at ("coordinates"));
  }

  std::string bytes;
  Eigen::AlignedBox2d box;

private:
  void
  write (const std::string& type, const Json& coordinates)
  {
    static const std::map<std::string, std::uint32_t> codes = {{"Point", 1},
                                                               {"LineString", 2},
                                                               {"Polygon", 3},
                                                               {"MultiLineString", 5},
                                                               {"MultiPolygon", 6}};
    constexpr std::uint32_t in_space = 1000;
    constexpr char little_endian = 1;
    const Json* place = &coordinates;
    while (!place->at (0).is_number())
      place = &place->at (0);
    bytes += little_endian;
    append (codes.at (type) + (place->size() == 3 ? in_space : 0), bytes);
    if (type == "Point")
      return writePlace (coordinates);
    writeCount (coordinates);
    for (const Json& part : coordinates)
      if (type == "LineString")
        writePlace (part);
      else if (type == "Polygon")
        writeRing (part);
      else
        write (type.substr (std::strlen ("Multi")), part);
  }

  void
  writeRing (const Json& ring)
  {
    writeCount (ring);
    for (const Json& place : ring)
      writePlace (place);
  }

  void
  writePlace (const Json& place)
  {
    box.extend (Eigen::Vector2d (place.at (0), place.at (1)));
    for (const Json& number : place)
      append (number.get<double>(), bytes);
  }

  void
  writeCount (const Json& list)
  {
    append (static_cast<std::uint32_t> (list.size()), bytes);
  }
};

/** \brief Returns a geometry as a GeoPackage blob: a header with reference system and
 * bounding box, then the well-known binary. Empty for null.
 * \param[in,out] around extended by the bounding box */
std::string
blobOf (const Json& geometry, int system, Eigen::AlignedBox2d& around)
{
  if (geometry.is_null())
    return {};
  const Wkb wkb (geometry);
  around.extend (wkb.box);
  constexpr char version = 0;
  constexpr char little_endian_with_box = 3;
  std::string blob = {'G', 'P', version, little_endian_with_box};
  append (static_cast<std::uint32_t> (system), blob);
  for (const int axis : {0, 1})
    for (const double limit : {wkb.box.min()[axis], wkb.box.max()[axis]})
      append (limit, blob);
  return blob + wkb.bytes;
}

/** \brief Returns the names of all properties with their SQL types; "" for a property
 * that is null or a list in all features. */
std::vector<std::pair<std::string, std::string>>
columnTypesOf (const Json& features)
{
  std::vector<std::pair<std::string, std::string>> columns;
  for (const Json& feature : features)
    for (const auto& [name, value] : feature.at ("properties").items()) {
      auto known = columns.begin();
      while (known != columns.end() && known->first != name)
        ++known;
      if (known == columns.end())
        known = columns.insert (known, {name, ""});
      if (value.is_string())
        known->second = "TEXT";
      else if (value.is_number_float() ||
               (value.is_number() && known->second != "REAL"))
        known->second = value.is_number_float() ? "REAL" : "INTEGER";
    }
  return columns;
}

/** \brief Returns the EPSG code that a map names, else -1 (undefined Cartesian). */
int
systemOf (const Json& map)
{
  constexpr int unknown = -1;
  if (!map.contains ("crs"))
    return unknown;
  const auto name = map.at ("crs").at ("properties").at ("name").get<std::string>();
  return std::stoi (name.substr (name.rfind (':') + 1));
}

/** \brief Inserts the features. \return their bounding box in x and y */
Eigen::AlignedBox2d
addFeatures (const Json& features,
             const std::string& layer,
             int system,
             Database& database)
{
  const auto columns = columnTypesOf (features);
  std::string declared;
  std::string values;
  for (const auto& [name, type] : columns) {
    declared += ", \"" + name + "\" " + (type.empty() ? "TEXT" : type);
    values += ", ?";
  }
  database.run ("CREATE TABLE \"" + layer +
                "\" (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom GEOMETRY" +
                declared + ")");
  Insertion row (database,
                 "INSERT INTO \"" + layer + "\" VALUES (NULL, ?" + values + ")");
  Eigen::AlignedBox2d box;
  for (const Json& feature : features) {
    row.addBlob (blobOf (feature.at ("geometry"), system, box));
    for (const auto& [name, type] : columns)
      row.add (feature.at ("properties").value (name, Json()));
    row.run();
  }
  return box;
}

/** \brief Registers the layer, so that readers find it. */
void
addContents (const std::string& layer,
             int system,
             const Eigen::AlignedBox2d& box,
             Database& database)
{
  // A fixed date instead of the time of writing: the same map gives the same bytes.
  Insertion contents (database,
                      "INSERT INTO gpkg_contents VALUES (?, 'features', ?, '', "
                      "'1970-01-01T00:00:00.000Z', ?, ?, ?, ?, ?)");
  contents.add (layer);
  contents.add (layer);
  for (const double limit : {box.isEmpty() ? 0.0 : box.min().x(),
                             box.isEmpty() ? 0.0 : box.min().y(),
                             box.isEmpty() ? 0.0 : box.max().x(),
                             box.isEmpty() ? 0.0 : box.max().y()})
    contents.add (limit);
  contents.add (system);
  contents.run();
  Insertion column (
      database,
      "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'GEOMETRY', ?, "
      "2, 0)"); // 2: geometries may have z
  column.add (layer);
  column.add (system);
  column.run();
}

} // namespace

bool
hasSqlite ()
{
  return true;
}

std::string
geoPackageOf (const std::string& geo_json, const std::string& layer)
{
  const Json map = Json::parse (geo_json);
  const int system = systemOf (map);
  Database database;
  database.run (geopackage_tables);
  // The definition stays undefined: readers know a reference system by its EPSG code.
  if (system > 0)
    database.run (
        str (boost::format ("INSERT OR IGNORE INTO gpkg_spatial_ref_sys VALUES "
                            "('EPSG:%1%', %1%, 'EPSG', %1%, 'undefined', NULL)") %
             system));
  database.run ("BEGIN");
  const Eigen::AlignedBox2d box =
      addFeatures (map.at ("features"), layer, system, database);
  addContents (layer, system, box, database);
  database.run ("COMMIT");
  return database.bytes();
}

} // namespace pcl_ops::apps

#else

namespace pcl_ops::apps {

bool
hasSqlite ()
{
  return false;
}

std::string
geoPackageOf (const std::string& /*geo_json*/, const std::string& /*layer*/)
{
  throw std::logic_error ("built without SQLite");
}

} // namespace pcl_ops::apps

#endif
