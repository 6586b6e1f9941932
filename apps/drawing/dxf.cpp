// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/format.hpp>

#include <Eigen/Geometry>

#include "drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <locale>
#include <map>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief How many bytes follow the first one of a character in UTF-8. */
int
bytesThatFollow (unsigned char first)
{
  constexpr unsigned first_of_two = 0xc0;
  constexpr unsigned first_of_three = 0xe0;
  constexpr unsigned first_of_four = 0xf0;
  if (first >= first_of_four)
    return 3;
  if (first >= first_of_three)
    return 2;
  return first >= first_of_two ? 1 : 0;
}

/** \brief Text in ASCII, with other characters as \U+XXXX, which DXF reads. */
std::string
asciiOf (const std::string& text)
{
  constexpr unsigned bits_that_follow = 0x3f;
  constexpr unsigned ascii = 0x80;
  std::string written;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char> (text[i]);
    if (first < ascii) {
      written += first < ' ' ? ' ' : text[i];
      continue;
    }
    const int more = bytesThatFollow (first);
    unsigned code = first & (bits_that_follow >> more);
    for (int k = 0; k < more && i + 1 < text.size(); ++k)
      code = code << 6U | (static_cast<unsigned char> (text[++i]) & bits_that_follow);
    written += str (boost::format ("\\U+%04X") % code);
  }
  return written;
}

/** \brief Pairs of group code and value, one line each (AutoCAD 2000 DXF reference).
 * Each object has a handle of its own and names that of its owner. */
class DxfText {
public:
  DxfText()
  {
    text_.imbue (std::locale::classic());
    text_ << std::setprecision (12);
  }

  template <typename Value>
  DxfText&
  put (int code, const Value& value)
  {
    text_ << code << '\n' << value << '\n';
    return *this;
  }

  DxfText&
  place (int code, const Eigen::Vector3d& at)
  {
    constexpr int to_y = 10;
    constexpr int to_z = 20;
    return put (code, at.x()).put (code + to_y, at.y()).put (code + to_z, at.z());
  }

  /** \brief Begins an object. \return its handle */
  std::string
  object (const char* type, const std::string& owner)
  {
    const std::string handle = str (boost::format ("%X") % ++last_handle_);
    put (0, type).put (std::string (type) == "DIMSTYLE" ? 105 : 5, handle);
    put (330, owner);
    return handle;
  }

  DxfText&
  kind (const char* name)
  {
    return put (100, name);
  }

  std::string
  text () const
  {
    return text_.str();
  }

private:
  std::ostringstream text_;
  unsigned last_handle_ = 0x1f;
};

// Handles of objects that others refer to before they are written.
constexpr const char *root = "C", *groups = "D", *model_space = "1F",
                     *paper_space = "1B", *none = "0";

Eigen::AlignedBox3d
boxAround (const Drawing& drawing)
{
  Eigen::AlignedBox3d box;
  for (const DrawnLine& line : drawing.lines)
    for (const Eigen::Vector3d& corner : line.corners)
      box.extend (corner);
  for (const DrawnText& text : drawing.texts)
    box.extend (text.at);
  return box.isEmpty() ? Eigen::AlignedBox3d (Eigen::Vector3d (0, 0, 0),
                                              Eigen::Vector3d (1, 1, 1))
                       : box;
}

/** \brief Returns the number of a unit in $INSUNITS of DXF; 0 for unknown units.
 * \param[in] meter length of a meter in that unit */
int
unitNumber (double meter)
{
  struct Unit {
    int number;
    double meter;
  };
  constexpr double tolerance = 1e-4; // for 3.2808, and for feet of the US survey
  for (const Unit unit :
       {Unit{1, 1.0 / 0.0254}, {2, 1.0 / 0.3048}, {4, 1000.0}, {5, 100.0}, {6, 1.0}})
    if (std::abs (meter / unit.meter - 1.0) < tolerance)
      return unit.number;
  return 0;
}

void
putHeader (const Eigen::AlignedBox3d& box, double meter, DxfText& dxf)
{
  constexpr int metric = 1;
  dxf.put (0, "SECTION").put (2, "HEADER");
  dxf.put (9, "$ACADVER").put (1, "AC1015");
  dxf.put (9, "$HANDSEED").put (5, "FFFFFF");
  dxf.put (9, "$INSUNITS").put (70, unitNumber (meter));
  dxf.put (9, "$MEASUREMENT").put (70, metric);
  dxf.put (9, "$EXTMIN").place (10, box.min());
  dxf.put (9, "$EXTMAX").place (10, box.max());
  dxf.put (0, "ENDSEC");
  dxf.put (0, "SECTION").put (2, "CLASSES").put (0, "ENDSEC");
}

/** \brief Writes a table; \p put_entries gets the table's handle. */
template <typename PutEntries>
void
putTable (const char* name, int size, DxfText& dxf, const PutEntries& put_entries)
{
  dxf.put (0, "TABLE").put (2, name);
  static const std::map<std::string, std::string> handles = {{"VPORT", "8"},
                                                             {"LTYPE", "5"},
                                                             {"LAYER", "2"},
                                                             {"STYLE", "3"},
                                                             {"VIEW", "6"},
                                                             {"UCS", "7"},
                                                             {"APPID", "9"},
                                                             {"DIMSTYLE", "A"},
                                                             {"BLOCK_RECORD", "1"}};
  const std::string& handle = handles.at (name);
  dxf.put (5, handle).put (330, none).kind ("AcDbSymbolTable").put (70, size);
  if (std::string (name) == "DIMSTYLE")
    dxf.kind ("AcDbDimStyleTable");
  put_entries (handle);
  dxf.put (0, "ENDTAB");
}

DxfText&
putEntry (const char* type,
          const char* kind,
          const std::string& name,
          const std::string& owner,
          DxfText& dxf)
{
  dxf.object (type, owner);
  return dxf.kind ("AcDbSymbolTableRecord").kind (kind).put (2, name).put (70, 0);
}

void
putView (const Eigen::AlignedBox3d& box, DxfText& dxf)
{
  constexpr double margin = 1.1;
  constexpr double aspect = 1.5;
  const Eigen::Vector3d middle = box.center();
  const Eigen::Vector3d sizes = box.sizes();
  putTable ("VPORT", 1, dxf, [&] (const std::string& table) {
    putEntry ("VPORT", "AcDbViewportTableRecord", "*Active", table, dxf);
    dxf.put (10, 0.0).put (20, 0.0).put (11, 1.0).put (21, 1.0);
    dxf.put (12, middle.x()).put (22, middle.y());
    dxf.place (16, Eigen::Vector3d::UnitZ()).place (17, Eigen::Vector3d::Zero());
    dxf.put (40, margin * std::max ({sizes.y(), sizes.x() / aspect, 1.0}));
    dxf.put (41, aspect);
  });
}

constexpr const char* dashed = "DASHED";

void
putLineTypes (DxfText& dxf)
{
  putTable ("LTYPE", 4, dxf, [&] (const std::string& table) {
    for (const char* const name : {"ByBlock", "ByLayer", "Continuous"})
      putEntry ("LTYPE", "AcDbLinetypeTableRecord", name, table, dxf)
          .put (3, "")
          .put (72, 65)
          .put (73, 0)
          .put (40, 0.0);
    constexpr double dash = 0.2;
    constexpr double gap = 0.1; // [m]
    putEntry ("LTYPE", "AcDbLinetypeTableRecord", dashed, table, dxf)
        .put (3, "__ __ __")
        .put (72, 65)
        .put (73, 2)
        .put (40, dash + gap)
        .put (49, dash)
        .put (74, 0)
        .put (49, -gap)
        .put (74, 0);
  });
}

void
putLayers (const std::vector<Layer>& layers, DxfText& dxf)
{
  const int black_or_white = 7;
  std::vector<Layer> all = {{"0", black_or_white, "", 0.25}};
  all.insert (all.end(), layers.begin(), layers.end());
  putTable (
      "LAYER", static_cast<int> (all.size()), dxf, [&] (const std::string& table) {
        for (const Layer& layer : all)
          putEntry ("LAYER", "AcDbLayerTableRecord", layer.name, table, dxf)
              .put (62, layer.number_of_color)
              .put (6, layer.is_dashed ? dashed : "Continuous")
              .put (370, std::lround (100.0 * layer.width)); // hundredths of a mm
      });
}

void
putOtherTables (DxfText& dxf)
{
  putTable ("STYLE", 1, dxf, [&] (const std::string& table) {
    putEntry ("STYLE", "AcDbTextStyleTableRecord", "Standard", table, dxf)
        .put (40, 0.0)
        .put (41, 1.0)
        .put (50, 0.0)
        .put (71, 0)
        .put (42, 0.2)
        .put (3, "txt")
        .put (4, "");
  });
  for (const char* const name : {"VIEW", "UCS"})
    putTable (name, 0, dxf, [] (const std::string&) {});
  putTable ("APPID", 1, dxf, [&] (const std::string& table) {
    putEntry ("APPID", "AcDbRegAppTableRecord", "ACAD", table, dxf);
  });
  putTable ("DIMSTYLE", 1, dxf, [&] (const std::string& table) {
    putEntry ("DIMSTYLE", "AcDbDimStyleTableRecord", "Standard", table, dxf);
  });
}

struct Space {
  const char *name, *handle, *begin, *end;
};

constexpr Space spaces[] = {{"*Model_Space", model_space, "1C", "1D"},
                            {"*Paper_Space", paper_space, "1A", "1E"}};

void
putTables (const Drawing& drawing, const Eigen::AlignedBox3d& box, DxfText& dxf)
{
  dxf.put (0, "SECTION").put (2, "TABLES");
  putView (box, dxf);
  putLineTypes (dxf);
  putLayers (drawing.layers, dxf);
  putOtherTables (dxf);
  putTable ("BLOCK_RECORD", 2, dxf, [&] (const std::string& table) {
    for (const Space& space : spaces)
      dxf.put (0, "BLOCK_RECORD")
          .put (5, space.handle)
          .put (330, table)
          .kind ("AcDbSymbolTableRecord")
          .kind ("AcDbBlockTableRecord")
          .put (2, space.name);
  });
  dxf.put (0, "ENDSEC");
}

void
putBlocks (DxfText& dxf)
{
  dxf.put (0, "SECTION").put (2, "BLOCKS");
  for (const Space& space : spaces) {
    dxf.put (0, "BLOCK").put (5, space.begin).put (330, space.handle);
    dxf.kind ("AcDbEntity").put (8, "0").kind ("AcDbBlockBegin");
    dxf.put (2, space.name).put (70, 0).place (10, Eigen::Vector3d::Zero());
    dxf.put (3, space.name).put (1, "");
    dxf.put (0, "ENDBLK").put (5, space.end).put (330, space.handle);
    dxf.kind ("AcDbEntity").put (8, "0").kind ("AcDbBlockEnd");
  }
  dxf.put (0, "ENDSEC");
}

std::string
putEntity (const char* type,
           const std::string& layer,
           DxfText& dxf,
           const std::string& owner = model_space)
{
  std::string handle = dxf.object (type, owner);
  dxf.kind ("AcDbEntity").put (8, layer);
  return handle;
}

void
putLine (const DrawnLine& line, DxfText& dxf)
{
  const Ring& corners = line.corners;
  const bool is_flat = std::all_of (
      corners.begin(), corners.end(), [] (const auto& c) { return c.z() == 0.0; });
  const int closed = line.is_closed ? 1 : 0;
  if (corners.size() == 2 && !line.is_closed) {
    putEntity ("LINE", line.layer, dxf);
    dxf.kind ("AcDbLine").place (10, corners[0]).place (11, corners[1]);
    return;
  }
  if (is_flat) {
    putEntity ("LWPOLYLINE", line.layer, dxf);
    dxf.kind ("AcDbPolyline").put (90, corners.size()).put (70, closed);
    for (const Eigen::Vector3d& corner : corners)
      dxf.put (10, corner.x()).put (20, corner.y());
    return;
  }
  constexpr int in_space = 8;
  constexpr int vertex_in_space = 32;
  const std::string handle = putEntity ("POLYLINE", line.layer, dxf);
  dxf.kind ("AcDb3dPolyline").put (66, 1).place (10, Eigen::Vector3d::Zero());
  dxf.put (70, in_space + closed);
  for (const Eigen::Vector3d& corner : corners) {
    putEntity ("VERTEX", line.layer, dxf, handle);
    dxf.kind ("AcDbVertex").kind ("AcDb3dPolylineVertex").place (10, corner);
    dxf.put (70, vertex_in_space);
  }
  putEntity ("SEQEND", line.layer, dxf, handle);
}

void
putText (const DrawnText& text, DxfText& dxf)
{
  constexpr int centered = 1;
  constexpr int in_the_middle = 2;
  putEntity ("TEXT", text.layer, dxf);
  dxf.kind ("AcDbText").place (10, text.at).put (40, text.height);
  dxf.put (1, asciiOf (text.text)).put (72, centered).place (11, text.at);
  dxf.kind ("AcDbText").put (73, in_the_middle);
}

void
putObjects (DxfText& dxf)
{
  dxf.put (0, "SECTION").put (2, "OBJECTS");
  dxf.put (0, "DICTIONARY").put (5, root).put (330, none).kind ("AcDbDictionary");
  dxf.put (281, 1).put (3, "ACAD_GROUP").put (350, groups);
  dxf.put (0, "DICTIONARY").put (5, groups).put (330, root).kind ("AcDbDictionary");
  dxf.put (281, 1);
  dxf.put (0, "ENDSEC");
}

} // namespace

std::string
toDxf (const Drawing& drawing)
{
  DxfText dxf;
  const Eigen::AlignedBox3d box = boxAround (drawing);
  putHeader (box, drawing.meter, dxf);
  putTables (drawing, box, dxf);
  putBlocks (dxf);
  dxf.put (0, "SECTION").put (2, "ENTITIES");
  for (const DrawnLine& line : drawing.lines)
    putLine (line, dxf);
  for (const DrawnText& text : drawing.texts)
    putText (text, dxf);
  dxf.put (0, "ENDSEC");
  putObjects (dxf);
  dxf.put (0, "EOF");
  return dxf.text();
}

} // namespace pcl_ops::apps
