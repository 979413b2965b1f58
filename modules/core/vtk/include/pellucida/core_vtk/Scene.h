#pragma once
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <memory>
#include <vector>

#include "pellucida/core/ContactModel.h"
#include "pellucida/core/Event.h"
#include "pellucida/core/ForceRemarks.h"
#include "pellucida/core/Measurement.h"
#include "pellucida/core/Observation.h"
#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/Frozen.h"

namespace pellucida {

/// Everything known about one frame. Each step of the chain takes a scene and returns a new one with its own part
/// added: frame -> (tracking) membranes, tools -> (reconstruction) surface -> (mechanics) surface with forces, model.
/// The parts are frozen: a copy costs a few reference counts, and may be read from any thread. Parts not made yet are
/// empty.
struct Scene {
  double arrival_s = 0.0;             ///< session clock when the frame arrived: force age is counted from here
  long run_index = 0;                 ///< increases when the source restarts: steps with memory then reset
  FrameUse use = FrameUse::kMeasure;  ///< how far a batch takes it; a live run goes as far as its time allows
  Frozen<vtkImageData> frame;         ///< 1 component, 8 or 16 bit, spacing in um, origin (0, 0, 0)
  Frozen<vtkPolyData> membranes;      ///< one closed polyline a membrane; see SceneData.h
  Frozen<vtkPolyData> tools;          ///< needle and holder outlines; see SceneData.h
  Frozen<vtkPolyData> surface;        ///< both membranes revolved, with the force arrays after the mechanics step
  Frozen<vtkPolyData> model;          ///< the mass-spring-damper mesh in its solved shape (triangles)
  std::shared_ptr<const Observation> observation;  ///< the same contours and tools as plain numbers
  Measurement measurement;                         ///< the row of `measurements.csv`
  ForceRemarks remarks;                            ///< why there is no force, why to doubt it, other models
  ContactModel contact;                            ///< what the 1 kHz thread learns from this frame
  std::vector<Event> events;                       ///< events of this frame
};

}  // namespace pellucida
