// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include "airborne.h"
#include "hilly_street.h"
#include "missing.h"
#include "plaster.h"
#include "slabs.h"
#include "table.h"

namespace pcl_ops::simulation {

namespace {

Site
siteOf (const Simulation& simulation)
{
  return simulation.scene == "furniture" ? makeFurnishedCorner (simulation.seed)
         : simulation.hasLidar()         ? makeStreet (simulation.seed)
                                         : makeRoom (simulation.seed);
}

CameraNoise
noiseOf (const Simulation& simulation)
{
  CameraNoise noise{simulation.noise, simulation.has_raw_depth};
  if (simulation.scene == "room-kinect")
    noise.quantization = drawQuantization (simulation.seed);
  return noise;
}

/** Returns the number of points of a simulation, or \p scene_default if it gives none.
 */
std::size_t
pointsOr (double scene_default, const Simulation& simulation)
{
  return std::size_t (simulation.points.value_or (scene_default));
}

SimulatedCloud
simulateSurvey (const Simulation& simulation)
{
  constexpr double points = 600'000;
  return scanSurvey (makeSurvey (simulation.seed),
                     pointsOr (points, simulation),
                     simulation.noise,
                     simulation.seed);
}

SimulatedCloud
simulateRoundShapes (const Simulation& simulation)
{
  constexpr double points = 250'000; // about 5000 per square meter
  return simulateShapes (
      pointsOr (points, simulation), simulation.noise, simulation.seed);
}

SimulatedCloud
simulateAirborne (const Simulation& simulation)
{
  const AirborneSite site = makeAirborne (simulation.seed);
  const double points = site.density * site.width() * site.width();
  return scanAirborne (
      site, pointsOr (points, simulation), simulation.noise, simulation.seed);
}

SimulatedCloud
simulateHillyStreet (const Simulation& simulation)
{
  return scanHillyStreet (makeHillyStreet (simulation.seed),
                          simulation.noise,
                          simulation.seed,
                          simulation.organized);
}

SimulatedCloud
simulateTable (const Simulation& simulation)
{
  return scanTable (drawTableView (simulation.seed),
                    simulation.camera,
                    simulation.noise,
                    simulation.seed,
                    simulation.organized);
}

SimulatedCloud
simulatePlaster (const Simulation& simulation)
{
  Plaster plaster = drawPlaster (simulation.seed);
  plaster.points = pointsOr (double (plaster.points), simulation);
  return scanPlaster (plaster, simulation.noise, simulation.seed);
}

SimulatedCloud
simulateSlabs (const Simulation& simulation)
{
  const double points = drawPointCountOfSlabs (simulation.seed);
  return scanSlabs (makeSlabs (simulation.seed),
                    pointsOr (points, simulation),
                    simulation.noise,
                    simulation.seed);
}

/** Returns the planes of a scene's surfaces in the frame of a sensor.
 * \param[in] pose from the sensor's frame to that of the scene */
std::vector<Plane>
planesSeenFrom (const Isometry3d& pose, Scene scene)
{
  const Isometry3d to_sensor = pose.inverse();
  for (Body& body : scene.bodies)
    for (Shape& shape : body.shapes) {
      shape.center = to_sensor * shape.center;
      shape.u = to_sensor.linear() * shape.u;
      shape.v = to_sensor.linear() * shape.v;
    }
  return surfacePlanes (scene);
}

/** Simulates a room in the frame of the camera, as drivers of cameras give it: steps of
 * depth are steps of z, and missing readings of the scene "missing" are at the origin.
 */
SimulatedCloud
simulateInCameraFrame (const Simulation& simulation)
{
  const SensorView view = viewOf (simulation);
  Scan scan = view.scan (0);
  if (simulation.scene == "missing")
    zeroReadings (scan, missingShare (simulation.seed), simulation.seed);
  SimulatedCloud image = labeledBySize (
      toSurfaceCloud (scan, Isometry3d::Identity(), simulation.organized),
      planesSeenFrom (view.poses[0], view.scene));
  image.up = view.poses[0].linear().transpose() * Vector3d::UnitZ();
  return image;
}

/** Scenes for which \ref simulate calls a function of their own. */
constexpr struct {
  const char* scene;
  SimulatedCloud (*simulate) (const Simulation&);
} scenes_with_own_function[] = {{"survey", simulateSurvey},
                                {"shapes", simulateRoundShapes},
                                {"airborne", simulateAirborne},
                                {"street-hills", simulateHillyStreet},
                                {"table", simulateTable},
                                {"plaster", simulatePlaster},
                                {"slabs", simulateSlabs},
                                {"missing", simulateInCameraFrame},
                                {"room-kinect", simulateInCameraFrame}};

/** Draws a rotation and a shift, both with a normal distribution.
 * \param[in] size root mean square of the rotation angle [degree] and of the length of
 * the shift [cm] */
Isometry3d
drawPoseError (Random& random, double size)
{
  constexpr double degree = pi / 180.0;
  constexpr double centimeter = 0.01;
  const double sigma_of_each_axis = size / std::sqrt (3.0);
  const auto drawVector = [&] (double unit) {
    Vector3d drawn;
    for (double& number : drawn)
      number = unit * sigma_of_each_axis * random.gaussian();
    return drawn;
  };
  const Vector3d rotation = drawVector (degree);
  Isometry3d error = at (drawVector (centimeter));
  if (rotation.norm() > 0.0)
    error.rotate (Eigen::AngleAxisd (rotation.norm(), rotation.normalized()));
  return error;
}

} // namespace

SensorView
viewOf (const Simulation& simulation, std::size_t frames)
{
  const std::string& name = simulation.scene;
  const Seed seed = simulation.seed;
  const Site site = siteOf (simulation);
  const Poses poses = name == "walk"          ? drawWalk (site, frames, seed)
                      : name == "drive"       ? drawDrive (site, frames, seed)
                      : simulation.hasLidar() ? Poses{drawSensorPose (site, seed)}
                                              : Poses{drawCameraPose (site, seed)};
  const auto scan = [=] (std::size_t frame) {
    const View view{site.scene, poses[frame], seed + std::uint32_t (frame)};
    return simulation.hasLidar()
               ? scanAround (view, lidarOf (simulation.sensor), simulation.noise, frame)
               : scanByCamera (view, simulation.camera, noiseOf (simulation));
  };
  return {site.scene, poses, scan};
}

SimulatedCloud
simulate (const Simulation& simulation)
{
  for (const auto& [scene, simulateScene] : scenes_with_own_function)
    if (simulation.scene == scene)
      return simulateScene (simulation);
  if (simulation.points) // a scan of all surfaces, without a sensor
    return scanDensely (siteOf (simulation).scene,
                        std::size_t (*simulation.points),
                        simulation.noise,
                        simulation.seed);
  const SensorView view = viewOf (simulation);
  return labeledBySize (
      toSurfaceCloud (view.scan (0), view.poses[0], simulation.organized),
      surfacePlanes (view.scene));
}

Poses
measuredPoses (const Poses& poses, const PoseErrors& errors, Seed seed)
{
  Random random = randomFor (Purpose::PoseError, seed);
  Poses result;
  Isometry3d drifting = Isometry3d::Identity(); // the pose with the drift so far
  for (std::size_t i = 0; i < poses.size(); ++i) {
    drifting = i == 0 ? poses[0]
                      : drifting * poses[i - 1].inverse() * poses[i] *
                            drawPoseError (random, errors.drift);
    result.push_back (drifting * drawPoseError (random, errors.each));
  }
  return result;
}

} // namespace pcl_ops::simulation
