// Sessions from strangers: what a repair may touch, links, pipes, a writer that lives, and parts that ask for the
// world.
#include <sys/stat.h>
#include <vtkNew.h>

#include "SessionJson.h"
#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionExport.h"
#include "pellucida/session/SessionReader.h"
#include "pellucida/vtk_files/DataFile.h"

namespace pellucida {
namespace {

using namespace test;

class SessionHostile : public testing::Test {
 protected:
  void SetUp() override {
    write_session(session(), 3);
    fs::create_directories(outside());
  }
  fs::path session() const { return folder_ / "s"; }
  fs::path outside() const { return folder_ / "outside"; }

  // Every part but the header line.
  void behead(const char* table) const {
    const std::string text = text_of(session() / table);
    put(session() / table, text.substr(text.find('\n') + 1));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SessionHostile, NoRowIsTakenForALostHeader) {
  behead("measurements.csv");
  behead("events.csv");
  EXPECT_EQ(SessionReader(session()).steps().size(), 3U);
  expect_mended(session(), "measurements.csv:1: the header");
  EXPECT_EQ(SessionReader(session()).steps().size(), 3U);
  EXPECT_EQ(SessionReader(session()).events().size(), 1U);
  EXPECT_TRUE(lines_of(session() / "measurements.csv")[0].starts_with("frame,time_s"));
  EXPECT_FALSE(fs::exists(session() / "damaged/lines.txt"));
}

TEST_F(SessionHostile, NoRowIsTakenForALostHeaderInAnOlderSessionEither) {
  remove_checksums(session());
  behead("measurements.csv");
  behead("events.csv");
  expect_mended(session(), "events.csv:1: the header");
  EXPECT_EQ(SessionReader(session()).steps().size(), 3U);
  EXPECT_EQ(SessionReader(session()).events().size(), 1U);
}

TEST_F(SessionHostile, ADamagedHeaderIsKept) {
  std::string text = text_of(session() / "measurements.csv");
  put(session() / "measurements.csv", text.replace(2, 1, "X"));
  expect_mended(session(), "measurements.csv:1: the header");
  EXPECT_TRUE(mentions(lines_of(session() / "damaged/lines.txt"), "measurements.csv:1: frXme"));
}

TEST_F(SessionHostile, OthersTemporaryFilesStay) {
  for (const char* name : {"notes.tmp", "surface/mine.tmp", "session.json.tmp.tmp", "surface/surface_1.vtp.tmp"}) {
    put(session() / name, "mine");
  }
  EXPECT_TRUE(check_session(session(), false).fine());
  put(session() / "session.json.tmp", "half");
  put(session() / "frames/frame_00000007.vti.3.tmp", "half");
  expect_mended(session(), "2 unfinished temporary file(s)");
  EXPECT_FALSE(fs::exists(session() / "session.json.tmp"));
  for (const char* name : {"notes.tmp", "surface/mine.tmp", "session.json.tmp.tmp", "surface/surface_1.vtp.tmp"}) {
    EXPECT_EQ(text_of(session() / name), "mine") << name;
  }
}

// Other folders have tables of these names, too.
TEST_F(SessionHostile, AFolderThatIsNoSessionIsLeftAlone) {
  const fs::path export_folder = outside() / "x";
  export_session(session(), export_folder);
  put(outside() / "measurements.csv", "day,weight\n1,2\n");
  put(outside() / "session.json", R"({"windows": []})");
  for (const fs::path& folder : {outside(), export_folder}) {
    const std::string before = text_of(folder / "measurements.csv");
    EXPECT_THROW(check_session(folder, true), InputError) << folder;
    EXPECT_EQ(text_of(folder / "measurements.csv"), before);
    EXPECT_FALSE(fs::exists(folder / "session.pvd"));
    EXPECT_FALSE(fs::exists(folder / "damaged"));
  }
  EXPECT_EQ(text_of(outside() / "session.json"), R"({"windows": []})");
}

TEST_F(SessionHostile, NoFolderIsFollowedOutOfTheSession) {
  for (const char* name : {"surface", "frames", "haptics"}) {
    const fs::path folder = session() / name;
    const fs::path moved = outside() / (std::string("their_") + name);
    if (fs::exists(folder)) {
      fs::rename(folder, moved);
    } else {
      fs::create_directories(moved);
    }
    put(moved / "surface_00000009.vtp.tmp", "theirs");
    put(moved / "surface_00000001.vtp", "theirs");
    fs::create_directory_symlink(moved, folder);
    EXPECT_TRUE(mentions(check_session(session(), false).problems, std::string(name) + ": a link"));
    EXPECT_THROW(check_session(session(), true), InputError);
    EXPECT_EQ(text_of(moved / "surface_00000009.vtp.tmp"), "theirs");
    EXPECT_EQ(text_of(moved / "surface_00000001.vtp"), "theirs");
    EXPECT_TRUE(SessionReader(session()).load(1).surface.get() == nullptr);
  }
}

TEST_F(SessionHostile, NothingIsMovedThroughALink) {
  put(session() / "surface/surface_00000001.vtp", "damaged");
  fs::create_directory_symlink(outside(), session() / "damaged");
  EXPECT_THROW(check_session(session(), true), InputError);
  EXPECT_TRUE(fs::is_empty(outside()));
  EXPECT_EQ(text_of(session() / "surface/surface_00000001.vtp"), "damaged");
}

TEST_F(SessionHostile, NoTableIsReadOrWrittenThroughALink) {
  for (const char* name : {"measurements.csv", "events.csv", "checksums.csv", "session.pvd", "empty.vtp"}) {
    fs::rename(session() / name, outside() / name);
    const std::string before = text_of(outside() / name);
    fs::create_symlink(outside() / name, session() / name);
    EXPECT_THROW(check_session(session(), true), InputError) << name;
    EXPECT_EQ(text_of(outside() / name), before);
    fs::remove(session() / name);
    fs::rename(outside() / name, session() / name);
  }
  EXPECT_TRUE(check_session(session(), false).fine());
}

TEST_F(SessionHostile, OfALinkedPartOnlyTheLinkIsMoved) {
  const char* name = "surface/surface_00000001.vtp";
  fs::rename(session() / name, outside() / "theirs.vtp");
  fs::create_symlink(outside() / "theirs.vtp", session() / name);
  expect_mended(session(), std::string(name) + ": no file but a link");
  EXPECT_TRUE(fs::is_symlink(session() / "damaged/surface_00000001.vtp"));
  EXPECT_FALSE(fs::is_symlink(outside() / "theirs.vtp"));
}

TEST_F(SessionHostile, TheWriterFollowsNoLinkEither) {
  const fs::path fresh = outside() / "fresh";
  fs::create_directories(fresh);
  put(outside() / "theirs", "theirs");
  fs::create_symlink(outside() / "theirs", fresh / "session.json.tmp");
  write_session(fresh, 1);
  EXPECT_EQ(text_of(outside() / "theirs"), "theirs");
  EXPECT_TRUE(check_session(fresh, false).fine());
  // A link that leads nowhere is in the way like any other file.
  const fs::path other = outside() / "other";
  fs::create_directories(other);
  fs::create_symlink(outside() / "nowhere", other / "surface");
  EXPECT_THROW(write_session(other, 1), UsageError);
  EXPECT_FALSE(fs::exists(outside() / "nowhere"));
}

TEST_F(SessionHostile, PipesAreRefusedAndNotWaitedFor) {
  fs::remove(session() / "surface/surface_00000001.vtp");
  ASSERT_EQ(mkfifo((session() / "surface/surface_00000001.vtp").c_str(), 0600), 0);
  expect_mended(session(), "surface/surface_00000001.vtp: no file but a link, folder, pipe");
  fs::remove(session() / "session.json");
  ASSERT_EQ(mkfifo((session() / "session.json").c_str(), 0600), 0);
  EXPECT_FALSE(check_session(session(), false).fine());
  EXPECT_THROW(check_session(session(), true), InputError);
  EXPECT_THROW(SessionReader{session()}, InputError);
}

TEST_F(SessionHostile, ARunningRecordingIsNotRepaired) {
  const fs::path running = outside() / "running";
  SessionWriter writer(running, make_info());
  for (long frame = 0; frame < 3; ++frame) writer.write(make_scene(frame));
  const std::string head = text_of(running / "session.json");
  EXPECT_THROW(check_session(running, true), InputError);
  EXPECT_EQ(text_of(running / "session.json"), head);
  const SessionReport report = check_session(running, false);
  EXPECT_TRUE(report.fine()) << testing::PrintToString(report.problems);
  EXPECT_TRUE(mentions(report.notes, "a program is recording into this session"));
  writer.write(make_scene(3));
  writer.close();
  EXPECT_TRUE(check_session(running, true).fine());
  EXPECT_EQ(SessionReader(running).steps().size(), 4U);
}

// Each asks for something no session has; the file is named, and the rest of the session is as good as before.
TEST_F(SessionHostile, APartThatAsksForTheWorldIsNamed) {
  const fs::path file = session() / "surface/surface_00000001.vtp";
  const std::string whole = text_of(file);
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string text = whole;
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
  };
  const auto repeated = [](const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  const std::string array = "<DataArray type=\"Float32\" Name=\"a\" format=\"appended\" offset=\"0\"/>";
  const std::string many_points = with("NumberOfPoints=\"4\"", "NumberOfPoints=\"999999999999\"");
  const std::vector<std::string> parts{with("NumberOfPoints=\"4\"", "NumberOfPoints=\"-5\""),
                                       many_points,
                                       with("NumberOfComponents=\"3\"", "NumberOfComponents=\"4000000000\""),
                                       with("<PointData>", "<PointData>" + repeated(array, 100)),
                                       with("<PointData>", "<PointData>" + repeated(array, 100000)),
                                       with("<PolyData>", "<PolyData>" + repeated("<a>", 100000)),
                                       with("<PolyData>", "<PolyData>" + repeated("<a>", 100)),
                                       "<!DOCTYPE a [<!ENTITY b \"c\">]>" + whole,
                                       with("offset=\"0\"", "offset=\"99999999\""),
                                       with("offset=\"0\"", "offset=\"-1\""),
                                       with("LittleEndian", "BigEndian"),
                                       with("UInt32", "Int8"),
                                       with("vtkZLib", "vtkXYZ"),
                                       with("Float64", "String"),
                                       "",
                                       "<VTKFile>",
                                       whole.substr(0, whole.size() / 2) + "</VTKFile>"};
  for (const std::string& part : parts) {
    put(file, part);
    const SessionReport report = check_session(session(), false);
    EXPECT_TRUE(mentions(report.problems, "surface/surface_00000001.vtp: ")) << part.substr(0, 300);
    EXPECT_EQ(report.counts.files(SessionPart::kSurface), 2U);
  }
  const ExportReport exported = export_session(session(), outside() / "x", {.frames = "0,1,2"});
  EXPECT_EQ(exported.node_frames, (std::vector<long>{0, 2}));
  EXPECT_TRUE(mentions(exported.notes, "1 surface(s) left out")) << testing::PrintToString(exported.notes);
  expect_mended(session(), "surface/surface_00000001.vtp");
}

// Without checksums, whatever a bit is changed to is read or refused, and nothing else.
TEST_F(SessionHostile, AnyChangedBitIsReadOrRefused) {
  const auto flip = [](const std::string& whole, const auto& read) {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      std::string changed = whole;
      changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
      try {
        read(changed);
      } catch (const InputError&) {
      } catch (const std::bad_alloc&) {
      }
    }
  };
  const auto poly = [](const std::string& text) { poly_from(text); };
  flip(text_of(session() / "surface/surface_00000001.vtp"), poly);
  flip(text_of(session() / "membranes/membranes_00000001.vtp"), poly);
  flip(text_of(session() / "frames/frame_00000001.vti"), [](const std::string& text) { image_from(text); });
}

// Ids beyond the points, and sizes of a compressed block, right checksums or not.
TEST_F(SessionHostile, IdsAndBlocksAreHeldAgainstTheirFile) {
  const auto contours = [](vtkIdType last_id) {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (int i = 0; i < 3; ++i) points->InsertNextPoint(i, 0, 0);
    const vtkIdType ids[] = {0, 1, last_id};
    lines->InsertNextCell(3, ids);
    data->SetPoints(points);
    data->SetLines(lines);
    return serialise(data.Get());
  };
  EXPECT_NO_THROW(poly_from(contours(2)));
  for (const vtkIdType id : {vtkIdType{3}, vtkIdType{-1}, vtkIdType{1} << 40}) {
    EXPECT_THROW(poly_from(contours(id)), InputError) << id;
  }
  // The first block's number of parts is its first word.
  std::string text = contours(2);
  const auto data = text.find("_", text.find("AppendedData")) + 1;
  for (const char word : {'\x7F', '\xFF'}) {
    std::string changed = text;
    std::fill_n(changed.begin() + static_cast<long>(data), 4, word);
    EXPECT_THROW(poly_from(changed), InputError);
  }
}

// What a file says of itself is printed on a terminal.
TEST_F(SessionHostile, NoControlCharactersGetIntoTheReport) {
  remove_checksums(session());
  std::ofstream(session() / "measurements.csv", std::ios::app) << "\x1B[2J" << std::string(1000, 'x') << ",\x7F\n";
  const SessionReport report = check_session(session(), false);
  ASSERT_FALSE(report.problems.empty());
  for (const std::string& problem : report.problems) {
    EXPECT_LT(problem.size(), 400U);
    for (const char c : problem) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20U && c != '\x7F');
  }
}

TEST_F(SessionHostile, ATableOfAnotherProgramIsNotReadToItsEnd) {
  std::string text;
  for (int i = 0; i < 200000; ++i) text += "a\n";
  put(session() / "events.csv", text);
  EXPECT_THROW(check_session(session(), true), InputError);
  EXPECT_EQ(text_of(session() / "events.csv"), text);
}

}  // namespace
}  // namespace pellucida
