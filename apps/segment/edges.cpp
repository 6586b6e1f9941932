// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges.h"

#include <detection/plane_json.h>
#include <io/output_file.h>
#include <nlohmann/json.hpp>
#include <numbers/angles.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <locale>
#include <ostream>
#include <vector>

namespace pcl_ops::apps {

namespace {

/** \brief Corners first, then the ends of edges that are at no corner. */
struct Wires {
  std::vector<Eigen::Vector3d> places;
  /** \brief For each edge the places of its ends. */
  std::vector<std::array<std::size_t, 2>> ends;
};

std::size_t
placeOf (const Eigen::Vector3d& end, std::size_t corners, Wires& wires)
{
  const auto last = wires.places.begin() + static_cast<std::ptrdiff_t> (corners);
  // Ends that were drawn to a corner are the corner, to the last digit.
  const auto corner = std::find (wires.places.begin(), last, end);
  if (corner != last)
    return static_cast<std::size_t> (corner - wires.places.begin());
  wires.places.push_back (end);
  return wires.places.size() - 1;
}

Wires
wiresOf (const PlaneEdges& found)
{
  Wires wires;
  for (const PlaneCorner& corner : found.corners)
    wires.places.push_back (corner.position);
  for (const PlaneEdge& edge : found.edges) {
    const std::size_t from = placeOf (edge.from, found.corners.size(), wires);
    wires.ends.push_back ({from, placeOf (edge.to, found.corners.size(), wires)});
  }
  return wires;
}

/** \brief The same with the numbers of planes in place of their positions. */
PlaneEdges
numbered (PlaneEdges found, const std::vector<std::uint32_t>& ids)
{
  const auto number = [&ids] (auto& planes) {
    for (std::size_t& plane : planes)
      plane = ids[plane];
  };
  for (PlaneEdge& edge : found.edges)
    number (edge.planes);
  for (PlaneCorner& corner : found.corners)
    number (corner.planes);
  return found;
}

std::string
toJson (const PlaneEdges& found)
{
  nlohmann::ordered_json json;
  json["edges"] = json["corners"] = nlohmann::ordered_json::array();
  for (const PlaneEdge& edge : found.edges)
    json["edges"].push_back ({{"planes", edge.planes},
                              {"from", toArray (edge.from)},
                              {"to", toArray (edge.to)},
                              {"length", edge.length()},
                              {"angle", toDegrees (edge.angle)}});
  for (const PlaneCorner& corner : found.corners)
    json["corners"].push_back (
        {{"planes", corner.planes}, {"position", toArray (corner.position)}});
  constexpr int indent = 2;
  return json.dump (indent) + "\n";
}

void
writePlaces (const Wires& wires, const Eigen::Isometry3d& pose, std::ostream& stream)
{
  for (const Eigen::Vector3d& place : wires.places) {
    const Eigen::Vector3d moved = pose * place;
    stream << moved.x() << ' ' << moved.y() << ' ' << moved.z() << '\n';
  }
}

void
writePly (const PlaneEdges& found, std::ostream& stream)
{
  const Wires wires = wiresOf (found);
  stream << "ply\nformat ascii 1.0\nelement vertex " << wires.places.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement edge "
         << wires.ends.size()
         << "\nproperty int vertex1\nproperty int vertex2\nproperty int plane1\n"
            "property int plane2\nend_header\n";
  writePlaces (wires, Eigen::Isometry3d::Identity(), stream);
  for (std::size_t e = 0; e < wires.ends.size(); ++e) {
    const auto& planes = found.edges[e].planes;
    stream << wires.ends[e][0] << ' ' << wires.ends[e][1] << ' ' << planes[0] << ' '
           << planes[1] << '\n';
  }
}

void
writeVtk (const PlaneEdges& found, const Eigen::Isometry3d& pose, std::ostream& stream)
{
  const Wires wires = wiresOf (found);
  const std::size_t corners = found.corners.size();
  stream << "# vtk DataFile Version 3.0\nedges of planes\nASCII\nDATASET POLYDATA\n"
            "POINTS "
         << wires.places.size() << " double\n";
  writePlaces (wires, pose, stream);
  stream << "VERTICES " << corners << ' ' << 2 * corners << '\n';
  for (std::size_t corner = 0; corner < corners; ++corner)
    stream << "1 " << corner << '\n';
  stream << "LINES " << wires.ends.size() << ' ' << 3 * wires.ends.size() << '\n';
  for (const auto& [from, to] : wires.ends)
    stream << "2 " << from << ' ' << to << '\n';
}

} // namespace

void
saveEdges (const std::string& file,
           const Eigen::Isometry3d& sensor_pose,
           const PlaneEdges& found,
           const std::vector<std::uint32_t>& ids)
{
  const PlaneEdges edges = numbered (found, ids);
  const std::string extension = extensionOf (file);
  if (extension == ".json")
    return writeTextFile (file, toJson (edges));
  writeFile (file, [&] (std::ostream& stream) {
    stream.imbue (std::locale::classic());
    stream.precision (std::numeric_limits<double>::max_digits10);
    extension == ".vtk" ? writeVtk (edges, sensor_pose, stream)
                        : writePly (edges, stream);
  });
}

} // namespace pcl_ops::apps
