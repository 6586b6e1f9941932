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

/** \brief Checks the result of a function of SQLite. As the database is in memory, it
 * can fail only for lack of memory.
 * \throws std::bad_alloc if the code is not the expected one */
void
checkMemory (int code, int expected = SQLITE_OK)
{
  if (code != expected)
    throw std::bad_alloc();
}

/** \brief A database in memory. */
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

  /** \brief Returns the bytes that a file with the database would have. */
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

  /** \brief Sets the next value of the row; null for a value that is neither a number
   * nor a text. */
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

  /** \brief Sets the next value of the row to bytes, or to null if there are none. */
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

  /** \brief Inserts the row and begins the next one. */
  void
  run ()
  {
    checkMemory (sqlite3_step (statement_), SQLITE_DONE);
    checkMemory (sqlite3_reset (statement_));
    column_ = 0;
  }

private:
  sqlite3_stmt* statement_ = nullptr;
  /** \brief Number of the last value of the row that was set, from 1 on; 0 for none. */
  int column_ = 0;
};

/** \brief Appends the bytes of a number, the least significant one first. */
template <typename Integer>
void
append (Integer number, std::string& bytes)
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
  /** \param[in] geometry with one part at least */
  explicit Wkb (const Json& geometry)
  {
    write (geometry.at ("type").get<std::string>(), geometry.at ("coordinates"));
  }

  std::string bytes;
  Eigen::AlignedBox2d box;

private:
  /** \brief Appends a geometry.
   * \param[in] type, coordinates as in GeoJSON */
  void
  write (const std::string& type, const Json& coordinates)
  {
    static const std::map<std::string, std::uint32_t> codes = {{"Point", 1},
                                                               {"LineString", 2},
                                                               {"Polygon", 3},
                                                               {"MultiLineString", 5},
                                                               {"MultiPolygon", 6}};
    constexpr std::uint32_t z_code = 1000; // is added to the code of a type with z
    constexpr char little_endian = 1;
    const Json* first_position = &coordinates;
    while (!first_position->at (0).is_number())
      first_position = &first_position->at (0);
    const bool has_z = first_position->size() == 3;
    bytes += little_endian;
    append (codes.at (type) + (has_z ? z_code : 0), bytes);
    if (type == "Point")
      return writePosition (coordinates);
    writeCount (coordinates);
    for (const Json& part : coordinates)
      if (type == "LineString")
        writePosition (part);
      else if (type == "Polygon")
        writeRing (part);
      else
        write (type.substr (std::strlen ("Multi")), part);
  }

  void
  writeRing (const Json& ring)
  {
    writeCount (ring);
    for (const Json& position : ring)
      writePosition (position);
  }

  void
  writePosition (const Json& position)
  {
    box.extend (Eigen::Vector2d (position.at (0), position.at (1)));
    for (const Json& coordinate : position)
      append (coordinate.get<double>(), bytes);
  }

  void
  writeCount (const Json& list)
  {
    append (static_cast<std::uint32_t> (list.size()), bytes);
  }
};

/** \brief Returns a geometry as a GeoPackage blob: a header with reference system and
 * bounding box, then the well-known binary. Empty for null and for a geometry without
 * parts, which has no box.
 * \param[in] epsg code of the reference system, or -1
 * \param[in,out] layer_box is extended by the bounding box of the geometry */
std::string
blobOf (const Json& geometry, int epsg, Eigen::AlignedBox2d& layer_box)
{
  if (geometry.is_null() || geometry.at ("coordinates").empty())
    return {};
  const Wkb wkb (geometry);
  layer_box.extend (wkb.box);
  constexpr char version = 0;
  constexpr char flags = 3; // bit 0: little endian; bit 1: a box in x and y
  std::string blob = {'G', 'P', version, flags};
  append (static_cast<std::uint32_t> (epsg), blob);
  for (const int axis : {0, 1})
    for (const double limit : {wkb.box.min()[axis], wkb.box.max()[axis]})
      append (limit, blob);
  return blob + wkb.bytes;
}

/** \brief A column of the table of a layer. */
struct SqlColumn {
  std::string name;
  /** \brief SQL type; empty for a property that is null or a list in all features. */
  std::string type;
};

/** \brief Returns a column for each property of the features. A property with integers
 * and other numbers is REAL. */
std::vector<SqlColumn>
sqlColumnsOf (const Json& features)
{
  std::vector<SqlColumn> columns;
  for (const Json& feature : features)
    for (const auto& [name, value] : feature.at ("properties").items()) {
      auto column = columns.begin();
      while (column != columns.end() && column->name != name)
        ++column;
      if (column == columns.end())
        column = columns.insert (column, {name, ""});
      if (value.is_string())
        column->type = "TEXT";
      else if (value.is_number_float())
        column->type = "REAL";
      else if (value.is_number() && column->type != "REAL")
        column->type = "INTEGER";
    }
  return columns;
}

/** \brief Returns the EPSG code of the reference system that a map names; -1 if it
 * names none. */
int
epsgOf (const Json& map)
{
  constexpr int undefined_cartesian = -1;
  if (!map.contains ("crs"))
    return undefined_cartesian;
  // "urn:ogc:def:crs:EPSG::25832"
  const auto name = map.at ("crs").at ("properties").at ("name").get<std::string>();
  return std::stoi (name.substr (name.rfind (':') + 1));
}

/** \brief Creates the table of a layer with a row for each feature.
 * \param[in] epsg code of the reference system, or -1
 * \return the bounding box of the features in x and y */
Eigen::AlignedBox2d
addFeatures (const Json& features,
             const std::string& layer,
             int epsg,
             Database& database)
{
  const std::vector<SqlColumn> columns = sqlColumnsOf (features);
  std::string declarations;
  std::string placeholders;
  for (const SqlColumn& column : columns) {
    declarations +=
        ", \"" + column.name + "\" " + (column.type.empty() ? "TEXT" : column.type);
    placeholders += ", ?";
  }
  database.run ("CREATE TABLE \"" + layer +
                "\" (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom GEOMETRY" +
                declarations + ")");
  Insertion row (database,
                 "INSERT INTO \"" + layer + "\" VALUES (NULL, ?" + placeholders + ")");
  Eigen::AlignedBox2d box;
  for (const Json& feature : features) {
    row.addBlob (blobOf (feature.at ("geometry"), epsg, box));
    for (const SqlColumn& column : columns)
      row.add (feature.at ("properties").value (column.name, Json()));
    row.run();
  }
  return box;
}

/** \brief Registers a layer and its column of geometries, so that readers find them.
 * \param[in] epsg code of the reference system, or -1
 * \param[in] box around the features in x and y; may be empty */
void
registerLayer (const std::string& layer,
               int epsg,
               const Eigen::AlignedBox2d& box,
               Database& database)
{
  // The date is fixed, not that of writing, so that the same map gives the same bytes.
  Insertion contents (database,
                      "INSERT INTO gpkg_contents VALUES (?, 'features', ?, '', "
                      "'1970-01-01T00:00:00.000Z', ?, ?, ?, ?, ?)");
  contents.add (layer); // name of the table
  contents.add (layer); // identifier
  for (const double limit : {box.isEmpty() ? 0.0 : box.min().x(),
                             box.isEmpty() ? 0.0 : box.min().y(),
                             box.isEmpty() ? 0.0 : box.max().x(),
                             box.isEmpty() ? 0.0 : box.max().y()})
    contents.add (limit);
  contents.add (epsg);
  contents.run();
  // 2: geometries may have z; 0: they have no m.
  Insertion column (
      database,
      "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'GEOMETRY', ?, 2, 0)");
  column.add (layer);
  column.add (epsg);
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
  const int epsg = epsgOf (map);
  Database database;
  database.run (geopackage_tables);
  // The definition of the system is left out: readers know it by its EPSG code.
  if (epsg > 0)
    database.run (
        str (boost::format ("INSERT OR IGNORE INTO gpkg_spatial_ref_sys VALUES "
                            "('EPSG:%1%', %1%, 'EPSG', %1%, 'undefined', NULL)") %
             epsg));
  database.run ("BEGIN");
  const Eigen::AlignedBox2d box =
      addFeatures (map.at ("features"), layer, epsg, database);
  registerLayer (layer, epsg, box, database);
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
