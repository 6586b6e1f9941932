// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view_state.h"
#include <detection/methods.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <list>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The planes of one run with what is needed to show them. All vectors but
 * \ref labels and \ref edges have one entry per plane. */
struct FoundPlanes {
  /** \brief Direction against gravity, as given or found. */
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::vector<PlaneSegment> planes;
  std::vector<PlaneExtent> extents;
  PlaneEdges edges;
  /** \brief Which colour each has, as a label (\ref colorOfLabel). */
  std::vector<std::uint32_t> colors;
  /** \brief Per point: 0 for no plane, else its position in \ref planes plus 1. */
  std::vector<std::uint32_t> labels;
  /** \brief Which parameter most likely stands in the way where nothing was found. */
  std::string advice;
  /** \brief What was found of the up axis, where it was looked for. */
  std::string up_note;
};

/** \brief Runs the detector a state asks for and adds outlines and areas.
 * \throws UsageError or WorkError as the detector does */
FoundPlanes
findPlanes (const DetectionRun& run,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud);

/** \brief Colours for planes before merging that show what was merged: the largest part
 * of every merged plane keeps the plane's colour, the others get colours of their own.
 * \param[in] before, after of one cloud */
std::vector<std::uint32_t>
colorsBeforeMerging (const FoundPlanes& before, const FoundPlanes& after);

/** \brief The runs of a cloud that are being looked at: a detector works again only
 * when the method or the preset changes. */
class PlaneFinder {
public:
  PlaneFinder (DetectorOptions options, XyzCloud::ConstPtr cloud);

  /** \brief The planes of a run, valid until another method or preset is asked for.
   * \throws UsageError or WorkError as the detector does; then what was found before
   * stays valid */
  const FoundPlanes&
  find (const DetectionRun& run);

  /** \brief How often a detector has worked. */
  std::size_t
  numberOfDetections () const
  {
    return detections_;
  }

private:
  const FoundPlanes&
  detectOnce (const DetectionRun& run);

  struct Entry {
    DetectionRun run;
    FoundPlanes found;
  };

  DetectorOptions options_;
  XyzCloud::ConstPtr cloud_;
  /** \brief Of one method and preset. In a list entries stay where they are. */
  std::list<Entry> entries_;
  std::size_t detections_ = 0;
};

} // namespace pcl_ops::apps
