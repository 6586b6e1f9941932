// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/format.hpp>

#include <Eigen/Geometry>

#include "drawing.h"
#include <cli/text.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <locale>
#include <map>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief Returns how many bytes follow the first byte of a character in UTF-8. */
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

/** \brief Returns UTF-8 text as ASCII: characters beyond ASCII become \U+XXXX, as DXF
 * has them, or a question mark where four digits are too few. Control characters become
 * blanks, bytes that are no UTF-8 U+FFFD.
 * \param[in] given the name of a file may be no UTF-8 */
std::string
asciiOf (const std::string& given)
{
  const std::string text = validUtf8 (given);
  constexpr unsigned char last_ascii = 0x7f; // a control character, as those below ' '
  constexpr unsigned last_of_four_digits = 0xffff;
  // A byte that follows the first one of a character has six bits of its code.
  constexpr unsigned bits_of_following = 6, mask_of_following = 0x3f;
  std::string ascii;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char> (text[i]);
    if (first <= last_ascii) {
      ascii += first < ' ' || first == last_ascii ? ' ' : text[i];
      continue;
    }
    const int following = bytesThatFollow (first);
    // The first byte has five, four or three bits of the code if one, two or three
    // bytes follow.
    unsigned code = first & (mask_of_following >> following);
    for (int k = 0; k < following; ++k)
      code = code << bits_of_following |
             (static_cast<unsigned char> (text[++i]) & mask_of_following);
    ascii +=
        code <= last_of_four_digits ? str (boost::format ("\\U+%04X") % code) : "?";
  }
  return ascii;
}

// The first argument of `put` is a group code: it says what the value behind it is
// (AutoCAD 2000 DXF reference). These codes mean the same in all objects:
//   0           the type of an object, or the beginning or end of a section or table
//   1, 2, 3     a text, a name, a second name or a description
//   5           the handle of the object, a unique hexadecimal number; DIMSTYLE: 105
//   8           the layer
//   10, 20, 30  x, y and z of a point; 11, 21, 31 of a second point
//   100         the class that the following codes belong to
//   330         the handle of the owner
// The meaning of others depends on the type: 40 to 49 are lengths and factors, 70 to 79
// flags and numbers of elements.

/** \brief The text of a DXF: group codes and values, each in a line of its own. */
class DxfText {
public:
  DxfText()
  {
    constexpr int digits = 12; // 0.1 mm at 10^7 m from zero
    text_.imbue (std::locale::classic());
    text_ << std::setprecision (digits);
  }

  /** \brief Appends a group code and its value. */
  template <typename Value>
  DxfText&
  put (int code, const Value& value)
  {
    text_ << code << '\n' << value << '\n';
    return *this;
  }

  /** \brief Appends x, y and z of a point.
   * \param[in] code group code of x */
  DxfText&
  putPoint (int code, const Eigen::Vector3d& point)
  {
    const int y_code = code + 10, z_code = code + 20;
    return put (code, point.x()).put (y_code, point.y()).put (z_code, point.z());
  }

  /** \brief Begins an object.
   * \param[in] owner handle of the object that owns it
   * \return the handle of the new object */
  std::string
  beginObject (const char* type, const std::string& owner)
  {
    // In a DIMSTYLE 5 is the name of a block.
    const int handle_code = std::string (type) == "DIMSTYLE" ? 105 : 5;
    const std::string handle = str (boost::format ("%X") % ++last_handle_);
    put (0, type).put (handle_code, handle);
    put (330, owner);
    return handle;
  }

  /** \brief Begins the codes of a class. */
  DxfText&
  putClass (const char* name)
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
  /** \brief The last handle that \ref beginObject gave. Handles up to the initial value
   * are those of tables and the constants below. */
  unsigned last_handle_ = 0x1f;
};

// Handles of objects that others refer to before they are written, and 0 for no owner.
constexpr const char *root_dictionary = "C", *group_dictionary = "D",
                     *model_space = "1F", *paper_space = "1B", *no_owner = "0";

/** \brief Returns a box around the corners of lines and the middles of texts; the unit
 * cube if there are none. */
Eigen::AlignedBox3d
boxAround (const Drawing& drawing)
{
  Eigen::AlignedBox3d box;
  for (const DrawnLine& line : drawing.lines)
    for (const Eigen::Vector3d& corner : line.corners)
      box.extend (corner);
  for (const DrawnText& text : drawing.texts)
    box.extend (text.middle);
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
    double meter; // its length in this unit
  };
  constexpr Unit inch = {1, 1.0 / 0.0254}, foot = {2, 1.0 / 0.3048};
  constexpr Unit millimeter = {4, 1000.0}, centimeter = {5, 100.0},
                 one_meter = {6, 1.0};
  // So that 3.2808, and the US survey foot, are taken for feet.
  constexpr double tolerance = 1e-4;
  for (const Unit& unit : {inch, foot, millimeter, centimeter, one_meter})
    if (std::abs (meter / unit.meter - 1.0) < tolerance)
      return unit.number;
  return 0;
}

/** \brief Writes the sections HEADER and, empty, CLASSES.
 * \param[in] box around the drawing
 * \param[in] meter as of \ref unitNumber */
void
putHeaderSections (const Eigen::AlignedBox3d& box, double meter, DxfText& dxf)
{
  // 9 is the name of a variable; its value follows.
  constexpr int metric = 1;
  // The next free handle: as the objects are written later, a number above all of
  // theirs.
  constexpr const char* handle_seed = "FFFFFF";
  dxf.put (0, "SECTION").put (2, "HEADER");
  dxf.put (9, "$ACADVER").put (1, "AC1015");
  dxf.put (9, "$HANDSEED").put (5, handle_seed);
  dxf.put (9, "$INSUNITS").put (70, unitNumber (meter));
  dxf.put (9, "$MEASUREMENT").put (70, metric);
  dxf.put (9, "$EXTMIN").putPoint (10, box.min());
  dxf.put (9, "$EXTMAX").putPoint (10, box.max());
  dxf.put (0, "ENDSEC");
  dxf.put (0, "SECTION").put (2, "CLASSES").put (0, "ENDSEC");
}

/** \brief Writes a table.
 * \param[in] size number of its entries
 * \param[in] put_entries writes the entries, given the handle of the table */
template <typename PutEntries>
void
putTable (const char* name, int size, DxfText& dxf, const PutEntries& put_entries)
{
  dxf.put (0, "TABLE").put (2, name);
  // Handles of tables, which are below those that beginObject gives.
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
  dxf.put (5, handle).put (330, no_owner).putClass ("AcDbSymbolTable").put (70, size);
  if (std::string (name) == "DIMSTYLE")
    dxf.putClass ("AcDbDimStyleTable");
  put_entries (handle);
  dxf.put (0, "ENDTAB");
}

/** \brief Begins an entry of a table; the caller adds the other codes of its class.
 * \param[in] name of the entry
 * \param[in] table handle of the table */
DxfText&
putEntry (const char* type,
          const char* class_name,
          const std::string& name,
          const std::string& table,
          DxfText& dxf)
{
  dxf.beginObject (type, table);
  dxf.putClass ("AcDbSymbolTableRecord").putClass (class_name);
  return dxf.put (2, name).put (70, 0);
}

/** \brief Writes the view that a program shows first: the drawing from above. */
void
putView (const Eigen::AlignedBox3d& box, DxfText& dxf)
{
  // Chosen by eye.
  constexpr double margin_factor = 1.1; // size of the view by that of the drawing
  constexpr double aspect = 1.5;        // width of the view by its height
  constexpr double min_height = 1.0;    // [unit of the drawing]
  const Eigen::Vector3d middle = box.center();
  const Eigen::Vector3d sizes = box.sizes();
  const double height =
      margin_factor * std::max ({sizes.y(), sizes.x() / aspect, min_height});
  putTable ("VPORT", 1, dxf, [&] (const std::string& table) {
    putEntry ("VPORT", "AcDbViewportTableRecord", "*Active", table, dxf);
    // 10 and 11 lower left and upper right corner in the window (0 to 1), 12 center of
    // the view, 16 direction to the eye, 17 target, 40 height, 41 aspect
    dxf.put (10, 0.0).put (20, 0.0).put (11, 1.0).put (21, 1.0);
    dxf.put (12, middle.x()).put (22, middle.y());
    dxf.putPoint (16, Eigen::Vector3d::UnitZ()).putPoint (17, Eigen::Vector3d::Zero());
    dxf.put (40, height);
    dxf.put (41, aspect);
  });
}

/** \brief Name of the line type of LineStyle::Dashed. */
constexpr const char* dashed = "DASHED";

void
putLineTypes (DxfText& dxf)
{
  constexpr int alignment = 65; // the only one there is, the letter A
  // In the unit of the drawing: only plans, which are in meters, have dashes.
  constexpr double dash = 0.2, gap = 0.1;
  putTable ("LTYPE", 4, dxf, [&] (const std::string& table) {
    // 72 alignment, 73 number of dashes and gaps, 40 length of all of them, 49 length
    // of each (that of a gap is negative), 74 no symbol in it
    for (const char* const name : {"ByBlock", "ByLayer", "Continuous"})
      putEntry ("LTYPE", "AcDbLinetypeTableRecord", name, table, dxf)
          .put (3, "")
          .put (72, alignment)
          .put (73, 0)
          .put (40, 0.0);
    putEntry ("LTYPE", "AcDbLinetypeTableRecord", dashed, table, dxf)
        .put (3, "__ __ __")
        .put (72, alignment)
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
  constexpr double hundredths_in_millimeter = 100.0; // DXF has widths in hundredths
  // Each DXF has a layer called 0.
  std::vector<Layer> all = {{"0", CadColor::BlackOrWhite, "", 0.25}};
  all.insert (all.end(), layers.begin(), layers.end());
  // 62 color, 6 line type, 370 width of lines
  putTable (
      "LAYER", static_cast<int> (all.size()), dxf, [&] (const std::string& table) {
        for (const Layer& layer : all)
          putEntry ("LAYER", "AcDbLayerTableRecord", layer.name, table, dxf)
              .put (62, static_cast<int> (layer.cad_color))
              .put (6, layer.style == LineStyle::Dashed ? dashed : "Continuous")
              .put (370, std::lround (hundredths_in_millimeter * layer.width));
      });
}

/** \brief Writes the other tables that AutoCAD requires: each is empty or has one usual
 * entry. */
void
putOtherTables (DxfText& dxf)
{
  putTable ("STYLE", 1, dxf, [&] (const std::string& table) {
    // 40 height (0: each text has its own), 41 width factor, 50 slant, 71 not mirrored,
    // 42 last height, 3 and 4 names of fonts
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

/** \brief A block that has all entities of the model, or all of the sheets of paper. */
struct Space {
  const char* name;
  /** \brief Handles of the block record, and of the beginning and end of the block. */
  const char *handle, *begin, *end;
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
          .putClass ("AcDbSymbolTableRecord")
          .putClass ("AcDbBlockTableRecord")
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
    dxf.putClass ("AcDbEntity").put (8, "0").putClass ("AcDbBlockBegin");
    dxf.put (2, space.name).put (70, 0).putPoint (10, Eigen::Vector3d::Zero());
    // DXF repeats the name. 1 is the file that has the block, none for this one.
    dxf.put (3, space.name).put (1, "");
    dxf.put (0, "ENDBLK").put (5, space.end).put (330, space.handle);
    dxf.putClass ("AcDbEntity").put (8, "0").putClass ("AcDbBlockEnd");
  }
  dxf.put (0, "ENDSEC");
}

/** \brief Begins an entity; the caller adds the codes of its class.
 * \param[in] owner handle of the space or entity that owns it
 * \return the handle of the entity */
std::string
putEntity (const char* type,
           const std::string& layer,
           DxfText& dxf,
           const std::string& owner = model_space)
{
  std::string handle = dxf.beginObject (type, owner);
  dxf.putClass ("AcDbEntity").put (8, layer);
  return handle;
}

/** \brief Writes a line as the entity that \ref toDxf says. */
void
putDxfLine (const DrawnLine& line, DxfText& dxf)
{
  const Ring& corners = line.corners;
  const bool is_flat =
      std::all_of (corners.begin(), corners.end(), [] (const auto& corner) {
        return corner.z() == 0.0;
      });
  const int closed_flag = line.is_closed ? 1 : 0;
  if (corners.size() == 2 && !line.is_closed) {
    putEntity ("LINE", line.layer, dxf);
    dxf.putClass ("AcDbLine").putPoint (10, corners[0]).putPoint (11, corners[1]);
    return;
  }
  if (is_flat) {
    putEntity ("LWPOLYLINE", line.layer, dxf);
    constexpr int corner_count_code = 90;
    dxf.putClass ("AcDbPolyline")
        .put (corner_count_code, corners.size())
        .put (70, closed_flag);
    for (const Eigen::Vector3d& corner : corners)
      dxf.put (10, corner.x()).put (20, corner.y());
    return;
  }
  constexpr int in_space_flag = 8, vertex_in_space_flag = 32;
  const std::string handle = putEntity ("POLYLINE", line.layer, dxf);
  dxf.putClass ("AcDb3dPolyline")
      .put (66, 1) // vertices follow
      .putPoint (10, Eigen::Vector3d::Zero());
  dxf.put (70, in_space_flag + closed_flag);
  for (const Eigen::Vector3d& corner : corners) {
    putEntity ("VERTEX", line.layer, dxf, handle);
    dxf.putClass ("AcDbVertex").putClass ("AcDb3dPolylineVertex").putPoint (10, corner);
    dxf.put (70, vertex_in_space_flag);
  }
  putEntity ("SEQEND", line.layer, dxf, handle);
}

void
putText (const DrawnText& text, DxfText& dxf)
{
  // 40 height, 72 and 73 alignment
  constexpr int horizontally_centered = 1, vertically_centered = 2;
  putEntity ("TEXT", text.layer, dxf);
  dxf.putClass ("AcDbText").putPoint (10, text.middle).put (40, text.height);
  dxf.put (1, asciiOf (text.text)).put (72, horizontally_centered);
  dxf.putPoint (11, text.middle);
  // The class begins twice, as in the reference of DXF: 73 follows the second
  // beginning.
  dxf.putClass ("AcDbText").put (73, vertically_centered);
}

/** \brief Writes the dictionaries that AutoCAD requires: the root, and in it an empty
 * dictionary for groups. Codes 3 and 350 are the name and the handle of an entry, 281
 * says which entry stays where two have the same name: the old one. */
void
putObjects (DxfText& dxf)
{
  dxf.put (0, "SECTION").put (2, "OBJECTS");
  dxf.put (0, "DICTIONARY")
      .put (5, root_dictionary)
      .put (330, no_owner)
      .putClass ("AcDbDictionary");
  dxf.put (281, 1).put (3, "ACAD_GROUP").put (350, group_dictionary);
  dxf.put (0, "DICTIONARY")
      .put (5, group_dictionary)
      .put (330, root_dictionary)
      .putClass ("AcDbDictionary");
  dxf.put (281, 1);
  dxf.put (0, "ENDSEC");
}

} // namespace

std::string
toDxf (const Drawing& drawing)
{
  DxfText dxf;
  const Eigen::AlignedBox3d box = boxAround (drawing);
  putHeaderSections (box, drawing.meter, dxf);
  putTables (drawing, box, dxf);
  putBlocks (dxf);
  dxf.put (0, "SECTION").put (2, "ENTITIES");
  for (const DrawnLine& line : drawing.lines)
    putDxfLine (line, dxf);
  for (const DrawnText& text : drawing.texts)
    putText (text, dxf);
  dxf.put (0, "ENDSEC");
  putObjects (dxf);
  dxf.put (0, "EOF");
  return dxf.text();
}

} // namespace pcl_ops::apps
