# What most files include, by measured cost; resources/cmake/PellucidaModule.cmake says how a set is made.
set(standard_headers <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits>
  <map> <memory> <mutex> <numbers> <optional> <random> <set> <sstream> <stdexcept> <string> <string_view> <thread> <utility>
  <vector> <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <tl/expected.hpp>)

pellucida_add_header_set(plain HEADERS ${standard_headers} LIBRARIES Eigen3::Eigen tl::expected)
if(NOT PELLUCIDA_CORE_ONLY)
  pellucida_add_header_set(vtk
    HEADERS ${standard_headers} <vtkCellArray.h> <vtkCellData.h> <vtkDoubleArray.h> <vtkFieldData.h> <vtkFloatArray.h> <vtkImageData.h>
      <vtkInformation.h> <vtkInformationVector.h> <vtkIntArray.h> <vtkMultiBlockDataSet.h> <vtkNew.h> <vtkObjectFactory.h>
      <vtkPointData.h> <vtkPoints.h> <vtkPolyData.h> <vtkPolyDataAlgorithm.h> <vtkSmartPointer.h> <vtkStringArray.h>
    LIBRARIES Eigen3::Eigen tl::expected VTK::CommonCore VTK::CommonDataModel VTK::CommonExecutionModel)
endif()
