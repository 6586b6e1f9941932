// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include "found_planes.h"
#include <vtkActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <vector>

namespace pcl_ops::apps {

/** \brief The outline of every plane as a closed line.
 * \param[in] colors one per plane */
vtkSmartPointer<vtkActor>
outlinesOf (const FoundPlanes& found, const std::vector<pcl::RGB>& colors);

/** \brief Where two planes meet, as lines. */
vtkSmartPointer<vtkActor>
edgesOf (const FoundPlanes& found);

/** \brief Where three planes meet, as points. */
vtkSmartPointer<vtkActor>
cornersOf (const FoundPlanes& found);

/** \brief An arrow along the normal of every plane, from its centroid; longer for
 * larger planes. \param[in] colors one per plane */
vtkSmartPointer<vtkActor>
normalsOf (const FoundPlanes& found, const std::vector<pcl::RGB>& colors);

/** \brief A corner of the window. */
struct Corner {
  bool is_right = false;
  bool is_top = false;
};

/** \brief An empty text in a corner, legible over whatever is behind it. */
vtkSmartPointer<vtkTextActor>
textIn (const Corner& corner);

} // namespace pcl_ops::apps
