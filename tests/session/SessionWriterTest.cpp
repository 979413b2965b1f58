#include "pellucida/session/SessionWriter.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include <nlohmann/json.hpp>

#include "SameData.h"
#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {
namespace {

using namespace test;

// Any VTK program must be able to read the files: these tests use VTK's readers, not ours.
template <class Reader>
auto read(const fs::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return vtkSmartPointer(reader->GetOutput());
}

TEST(SessionWriter, LaysOutTheFolderOfTheContract) {
  const TemporaryFolder folder;
  write_session(folder / "s", 3);
  for (const char* name :
       {"session.json", "session.pvd", "measurements.csv", "events.csv", "frames/frame_00000000.vti",
        "membranes/membranes_00000001.vtp", "surface/surface_00000002.vtp", "tools/tools_00000002.vtp"}) {
    EXPECT_TRUE(fs::exists(folder / "s" / name)) << name;
  }
  EXPECT_FALSE(fs::exists(folder / "s" / "haptics"));
  for (const auto& entry : fs::recursive_directory_iterator(folder / "s")) {
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
  }
}

// Several sessions with parts in common: each is whole, and the same as if it had packed them itself.
TEST(SessionWriter, PartsThatWereMadeReadyElsewhereAreThoseOfTheScene) {
  const TemporaryFolder folder;
  write_session(folder / "alone", 4);
  CommonPacker packer;
  SessionWriter one(folder / "one", make_info(), {.sync = SessionSync::kAtEnd});
  SessionWriter other(folder / "other", make_info(), {.sync = SessionSync::kAtEnd});
  for (long frame = 0; frame < 4; ++frame) {
    const Scene scene = make_scene(frame);
    const Frozen surface(narrowed_surface(scene.surface.shallow_copy()));
    StepParts ready;
    ready.membranes = packer.pack(SessionPart::kMembranes, scene.membranes, scene.measurement);
    ready.tools = packer.pack(SessionPart::kTools, scene.tools, scene.measurement);
    ready.surface_arrays = packer.pack_arrays(surface);
    for (SessionWriter* writer : {&one, &other}) {
      ready.surface = surface.shallow_copy();
      writer->write(scene, ready);
    }
  }
  const SessionReader expected(folder / "alone");
  for (SessionWriter* writer : {&one, &other}) {
    writer->event({0.05, "contact", "needle, outer membrane"});
    writer->close();
    const SessionReport report = check_session(writer->folder(), false);
    EXPECT_TRUE(report.fine()) << testing::PrintToString(report.problems);
    const SessionReader session(writer->folder());
    EXPECT_EQ(session.stated_counts().byte_count, expected.stated_counts().byte_count);
    for (std::size_t step = 0; step < 4; ++step) {
      for (const SessionPart part : {SessionPart::kSurface, SessionPart::kMembranes, SessionPart::kTools}) {
        expect_same(session.load(step, part).shallow_copy(), expected.load(step, part).shallow_copy());
      }
    }
  }
  EXPECT_FALSE(packer.pack(SessionPart::kTools, {}, {}));
  EXPECT_FALSE(packer.pack_arrays({}));
}

TEST(SessionWriter, StampsEveryDataFile) {
  const TemporaryFolder folder;
  write_session(folder / "s", 3);
  for (const auto& name :
       {"membranes/membranes_00000002.vtp", "surface/surface_00000002.vtp", "tools/tools_00000002.vtp"}) {
    const auto data = read<vtkXMLPolyDataReader>(folder / "s" / name);
    ASSERT_TRUE(data->GetFieldData()->GetArray("time_s")) << name;
    EXPECT_EQ(data->GetFieldData()->GetArray("time_s")->GetDataType(), VTK_DOUBLE) << name;
    EXPECT_DOUBLE_EQ(data->GetFieldData()->GetArray("time_s")->GetComponent(0, 0), time_of(2)) << name;
    EXPECT_EQ(data->GetFieldData()->GetArray("frame_index")->GetComponent(0, 0), 2) << name;
    EXPECT_EQ(data->GetFieldData()->GetArray("schema_version")->GetComponent(0, 0), kSchemaVersion) << name;
  }
  const auto image = read<vtkXMLImageDataReader>(folder / "s/frames/frame_00000002.vti");
  EXPECT_DOUBLE_EQ(image->GetFieldData()->GetArray("time_s")->GetComponent(0, 0), time_of(2));
  EXPECT_DOUBLE_EQ(image->GetSpacing()[0], 0.825);
  EXPECT_DOUBLE_EQ(image->GetOrigin()[1], 0.0);
  EXPECT_EQ(image->GetScalarType(), VTK_UNSIGNED_CHAR);
}

TEST(SessionWriter, SurfaceHasTheArraysOfTheContract) {
  const TemporaryFolder folder;
  write_session(folder / "s", 2);
  const auto surface = read<vtkXMLPolyDataReader>(folder / "s/surface/surface_00000001.vtp");
  EXPECT_EQ(surface->GetNumberOfPolys(), 4);
  const std::vector<std::pair<const char*, int>> arrays{
      {"force_uN", 3}, {"force_sigma_uN", 1}, {"displacement_um", 3}, {"tension_uN_per_um", 1}, {"membrane", 1}};
  for (const auto& [name, components] : arrays) {
    vtkDataArray* array = surface->GetPointData()->GetArray(name);
    ASSERT_TRUE(array) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), 4) << name;
  }
  EXPECT_EQ(surface->GetPointData()->GetArray("force_uN")->GetComponent(3, 2), 33.0);
}

TEST(SessionWriter, MembranesAreClosedPolylinesWithTheirArrays) {
  const TemporaryFolder folder;
  write_session(folder / "s", 1);
  const auto membranes = read<vtkXMLPolyDataReader>(folder / "s/membranes/membranes_00000000.vtp");
  ASSERT_EQ(membranes->GetNumberOfLines(), 2);
  EXPECT_EQ(membranes->GetCellData()->GetArray("membrane")->GetComponent(1, 0), 1);
  EXPECT_EQ(membranes->GetPointData()->GetArray("sigma_um")->GetComponent(0, 0), 0.125);
  ASSERT_TRUE(membranes->GetPointData()->GetArray("confidence"));
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  membranes->GetCellPoints(0, size, ids);
  EXPECT_EQ(size, 13);
  EXPECT_EQ(ids[0], ids[12]);
  // The needle's tip is the first point of its line.
  const auto tools = read<vtkXMLPolyDataReader>(folder / "s/tools/tools_00000000.vtp");
  EXPECT_DOUBLE_EQ(tools->GetPoint(0)[0], 150.0);
}

TEST(SessionWriter, TablesHaveTheHeadersOfTheContract) {
  const TemporaryFolder folder;
  write_session(folder / "s", 2);
  const auto rows = rows_of(folder / "s/measurements.csv");
  EXPECT_TRUE(lines_of(folder / "s/measurements.csv")[0].ends_with(",row_crc32"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0],
            "frame,time_s,state,confidence,cell_x_um,cell_y_um,axis_deg,tip_x_um,tip_y_um,indentation_um,"
            "dimple_radius_um,contact_force_uN,contact_force_lower_uN,contact_force_upper_uN,pressure_Pa,volume_um3,"
            "frame_age_ms,lateral_force_uN,stiffness_uN_per_um,shape_residual_um,asymmetry_um,model_spread_percent,"
            "puncture_probability,contact_force_picture_lower_uN,contact_force_picture_upper_uN,"
            "contact_force_scale_lower_uN,contact_force_scale_upper_uN,expected_puncture_uN,expected_puncture_um,"
            "manipulator_x_um,manipulator_y_um,strain_stiffening,strain_stiffening_lower,strain_stiffening_upper");
  EXPECT_EQ(rows[2], "1,0.0333333333,contact,0.75,100,80,0,150,80,3,0,0.5,,,,,,,,,,,,,,,,,,,,,,");
  const auto events = rows_of(folder / "s/events.csv");
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0], "time_s,kind,detail");
  EXPECT_EQ(events[1], "0.05,contact,\"needle, outer membrane\"");
}

TEST(SessionWriter, RowIsOnTheDiskWhenWriteReturns) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info());
  for (long frame = 0; frame < 3; ++frame) {
    writer.write(make_scene(frame));
    EXPECT_EQ(lines_of(folder / "s/measurements.csv").size(), static_cast<std::size_t>(frame) + 2);
  }
}

TEST(SessionWriter, WritesOnlyThePartsThatAreThere) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info());
  writer.write(make_empty_scene(0));
  Scene nothing;
  nothing.measurement.frame = 1;
  writer.write(nothing);
  writer.close();
  EXPECT_TRUE(fs::exists(folder / "s/frames/frame_00000000.vti"));
  EXPECT_FALSE(fs::exists(folder / "s/frames/frame_00000001.vti"));
  EXPECT_TRUE(fs::is_empty(folder / "s/surface"));
  EXPECT_TRUE(fs::is_empty(folder / "s/membranes"));
  EXPECT_EQ(rows_of(folder / "s/measurements.csv")[1], "0,0,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,");
  EXPECT_EQ(writer.counts().step_count, 2U);
  EXPECT_EQ(writer.counts().files(SessionPart::kFrame), 1U);
  EXPECT_TRUE(check_session(folder / "s", false).fine());
}

TEST(SessionWriter, LeavesOutTheFramesWhenAsked) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info(), {.frames = false});
  writer.write(make_scene(0));
  writer.close();
  EXPECT_FALSE(fs::exists(folder / "s/frames"));
  EXPECT_TRUE(fs::exists(folder / "s/surface/surface_00000000.vtp"));
  EXPECT_EQ(text_of(folder / "s/session.pvd").find("frame_"), std::string::npos);
  EXPECT_TRUE(check_session(folder / "s", false).fine());
}

TEST(SessionWriter, ListsEveryFileInThePvdWithTheSameBlocksAtEachTime) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info());
  for (long frame = 0; frame < 4; ++frame) writer.write(frame == 2 ? make_empty_scene(frame) : make_scene(frame));
  writer.close();
  auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromFile((folder / "s/session.pvd").c_str()));
  ASSERT_TRUE(root);
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* collection = root->FindNestedElementWithName("Collection");
  ASSERT_EQ(collection->GetNumberOfNestedElements(), 16);
  for (int i = 0; i < 16; ++i) {
    vtkXMLDataElement* entry = collection->GetNestedElement(i);
    EXPECT_EQ(entry->GetAttribute("part"), std::to_string(i % 4));
    EXPECT_NEAR(std::stod(entry->GetAttribute("timestep")), time_of(i / 4), 1e-9);
    EXPECT_TRUE(fs::exists(folder / "s" / entry->GetAttribute("file"))) << entry->GetAttribute("file");
  }
  EXPECT_STREQ(collection->GetNestedElement(4)->GetAttribute("file"), "surface/surface_00000001.vtp");
  EXPECT_STREQ(collection->GetNestedElement(8)->GetAttribute("file"), "empty.vtp");
}

TEST(SessionWriter, HeadTellsWhatTheContractAsksFor) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    const auto early = nlohmann::json::parse(text_of(folder / "s/session.json"));
    EXPECT_EQ(early["complete"], false);
    writer.write(make_scene(0));
    writer.write(make_empty_scene(1));
    writer.event({0.0, "dropped", "3 frames (within 2 to 7) kept without their image"});
    writer.event({0.0, "dropped", "frame 9"});
    writer.close();
  }
  const auto head = nlohmann::json::parse(text_of(folder / "s/session.json"));
  EXPECT_EQ(head["schema_version"], kSchemaVersion);
  EXPECT_EQ(head["software"]["version"], kVersion);
  EXPECT_EQ(head["complete"], true);
  EXPECT_EQ(head["calibration"]["pixel_size_um"], 0.825);
  EXPECT_EQ(head["calibration"]["pixel_size_origin"], "option");
  EXPECT_EQ(head["profile"]["content"]["material"]["poisson_ratio"], 0.49);
  EXPECT_EQ(head["source"]["name"], "a video.avi");
  EXPECT_EQ(head["seeds"]["noise"], 42);
  EXPECT_EQ(head["clock_offsets_s"]["camera"], -0.25);
  EXPECT_EQ(head["drop_policy"], "newest wins");
  EXPECT_EQ(head["counts"]["steps"], 2);
  EXPECT_EQ(head["counts"]["unmeasured"], 1);
  EXPECT_EQ(head["counts"]["surface"], 1);
  EXPECT_EQ(head["counts"]["events"], 2);
  EXPECT_EQ(head["counts"]["dropped"], 4);
}

TEST(SessionWriter, ScenesOwnEventsAreWritten) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info());
  Scene scene = make_scene(0);
  scene.events = {{0.0, "contact", "a \"quoted\" word"}, {0.01, "note", "two\nlines"}};
  writer.write(scene);
  const auto events = rows_of(folder / "s/events.csv");
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[1], "0,contact,\"a \"\"quoted\"\" word\"");
  EXPECT_EQ(events[2], "0.01,note,\"two lines\"");
}

// Events of frames are known later than those of the hand; who reads the closed table needs not know.
TEST(SessionWriter, ClosingPutsTheEventsInOrder) {
  const TemporaryFolder folder;
  {
    SessionWriter writer(folder / "s", make_info());
    writer.event({0.5, "limit", "depth"});
    writer.event({0.1, "contact", "first, of two"});
    writer.event({0.1, "note", "second"});
    writer.event({0.3, "puncture", ""});
    EXPECT_EQ(lines_of(folder / "s/events.csv").size(), 5U);  // written at once all the same
    writer.close();
  }
  const std::vector<std::string> expected{"time_s,kind,detail", "0.1,contact,\"first, of two\"", "0.1,note,second",
                                          "0.3,puncture,", "0.5,limit,depth"};
  EXPECT_EQ(rows_of(folder / "s/events.csv"), expected);
  EXPECT_TRUE(check_session(folder / "s", false).fine());
}

// Quick packing is larger, and read all the same.
TEST(SessionWriter, QuickPackingKeepsEveryPixel) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> pixels(256 * 256, 7);
  pixels[1234] = 9;
  std::uintmax_t bytes[2] = {};
  for (const Packing packing : {Packing::kSmall, Packing::kQuick}) {
    const fs::path session = folder / (packing == Packing::kQuick ? "quick" : "small");
    Scene scene = make_scene(0);
    scene.frame = Frozen(make_frame({pixels.data(), PixelFormat::kGray8, 256, 256, 256, 0.825}, time_of(0), 0));
    SessionInfo info = make_info();
    info.source.width_px = info.source.height_px = 256;
    SessionWriter writer(session, info);
    writer.write(scene, packing);
    EXPECT_GT(writer.last_cost().packing_s, 0.0);
    EXPECT_GT(writer.last_cost().disk_s, 0.0);
    writer.close();
    bytes[packing == Packing::kQuick] = fs::file_size(session / "frames/frame_00000000.vti");
    const Scene back = SessionReader(session).load(0);
    const ImageView view = view_of(back.frame.get());
    EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), static_cast<const std::uint8_t*>(view.data)));
    EXPECT_TRUE(check_session(session, false).fine());
  }
  EXPECT_GT(bytes[1], 256U * 256U);
  EXPECT_LT(bytes[0], bytes[1] / 4);
}

TEST(SessionWriter, RowDecidesWhatAPartIsStampedWith) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info());
  Scene scene = make_scene(5);
  scene.measurement.frame = 8;
  scene.measurement.time_s = 1.5;
  writer.write(scene);
  const auto surface = read<vtkXMLPolyDataReader>(folder / "s/surface/surface_00000008.vtp");
  EXPECT_EQ(stamped_frame_index(surface), 8);
  EXPECT_EQ(stamped_time_s(surface), 1.5);
  // The frozen part itself stays as it was.
  EXPECT_EQ(stamped_frame_index(scene.surface.get()), 5);
}

TEST(SessionWriter, NeverOverwritesASession) {
  const TemporaryFolder folder;
  write_session(folder / "s", 2);
  const std::string before = text_of(folder / "s/measurements.csv");
  try {
    SessionWriter writer(folder / "s", make_info());
    FAIL() << "a session was overwritten";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("choose another folder"), std::string::npos) << error.what();
    EXPECT_EQ(error.code(), ExitCode::kWrongUsage);
  }
  EXPECT_EQ(text_of(folder / "s/measurements.csv"), before);
}

TEST(SessionWriter, TakesAFolderWithOtherThings) {
  const TemporaryFolder folder;
  put(folder / "readme.txt", "mine");
  EXPECT_NO_THROW(write_session(folder / "", 1));
  EXPECT_EQ(text_of(folder / "readme.txt"), "mine");
}

TEST(SessionWriter, UnwritableFolderIsAnOutputError) {
  const TemporaryFolder folder;
  put(folder / "file", "not a folder");
  for (const fs::path& target : {folder / "file", folder / "file/below", fs::path("/proc/pellucida-session")}) {
    try {
      SessionWriter writer(target, make_info());
      FAIL() << target << " was taken";
    } catch (const OutputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(error.code(), ExitCode::kOutputUnwritable);
      EXPECT_NE(text.find(target.string()), std::string::npos) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
  }
}

TEST(SessionWriter, RefusesAProfileThatIsNoJson) {
  const TemporaryFolder folder;
  SessionInfo info = make_info();
  info.profile_json = "{ not json";
  EXPECT_THROW(SessionWriter(folder / "s", info), UsageError);
}

TEST(SessionWriter, RefusesAFrameThatDoesNotRise) {
  const TemporaryFolder folder;
  SessionWriter writer(folder / "s", make_info());
  writer.write(make_scene(3));
  EXPECT_THROW(writer.write(make_scene(3)), Error);
  EXPECT_THROW(writer.write(make_scene(2)), Error);
  EXPECT_NO_THROW(writer.write(make_scene(7)));
  writer.close();
  EXPECT_NO_THROW(writer.close());
  EXPECT_THROW(writer.write(make_scene(8)), Error);
}

}  // namespace
}  // namespace pellucida
