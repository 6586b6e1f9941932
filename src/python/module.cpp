// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detectors.h"
#include "evaluation.h"
#include "plane_lists.h"
#include "segmentation.h"

PYBIND11_MODULE (_pcl_ops, module)
{
  using namespace pcl_ops::python;
  module.attr ("__version__") = PCL_OPS_VERSION;
  definePlane (module);
  // What is documented, has defaults and checks its arrays is in pcl_ops/__init__.py.
  module.def ("segment", &segment);
  module.def ("parameters", &parametersOf);
  module.def ("filter_planes", &filteredPlanes);
  module.def ("match_planes", &matchedPlanes);
  module.def ("merge_planes", &mergedPlanes);
  module.def ("estimate_up_axis", &upAxisOf);
  module.def ("evaluate", &evaluate);
}
