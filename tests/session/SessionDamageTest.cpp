// Sessions that were changed after they were written: what checksums show, and what older sessions without them are.
#include <functional>

#include "SessionIndex.h"
#include "SessionJson.h"
#include "TestSession.h"
#include "pellucida/core/Error.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionExport.h"
#include "pellucida/session/SessionReader.h"

namespace pellucida {
namespace {

using namespace test;

class SessionDamage : public testing::Test {
 protected:
  void SetUp() override { write_session(session(), 3); }
  fs::path session() const { return folder_ / "s"; }
  fs::path other() const { return folder_ / "other"; }

  // Runs `expect` with one bit of each byte of `name` changed; of a longer file, of some 200 all over it.
  void flip_bits(const std::string& name, const std::function<void(std::size_t)>& expect) const {
    const std::string whole = text_of(session() / name);
    for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 200) {
      std::string changed = whole;
      changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
      put(session() / name, changed);
      expect(i);
    }
    put(session() / name, whole);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(SessionDamage, AChangedBitOfADataFileIsSeen) {
  const SessionReader reader(session());
  for (const auto& [part, name] : {std::pair{SessionPart::kSurface, "surface/surface_00000001.vtp"},
                                   std::pair{SessionPart::kMembranes, "membranes/membranes_00000001.vtp"}}) {
    flip_bits(name,
              [&, kind = part](std::size_t i) { EXPECT_THROW(reader.load(1, kind), InputError) << "byte " << i; });
    EXPECT_NO_THROW(reader.load(1, part));
  }
  flip_bits("frames/frame_00000001.vti",
            [&](std::size_t i) { EXPECT_THROW(reader.load(1), InputError) << "byte " << i; });
}

TEST_F(SessionDamage, AChangedBitOfARowIsSeen) {
  const auto expect_seen = [&](const auto& table, std::size_t i) {
    EXPECT_TRUE(!table.bad.empty() || !table.header_right) << "byte " << i;
  };
  flip_bits("measurements.csv",
            [&](std::size_t i) { expect_seen(read_measurements(session() / "measurements.csv"), i); });
  flip_bits("events.csv", [&](std::size_t i) { expect_seen(read_events(session() / "events.csv"), i); });
  flip_bits("checksums.csv", [&](std::size_t i) { expect_seen(read_checksums(session() / "checksums.csv"), i); });
}

TEST_F(SessionDamage, AChangedNumberIsNamedAndKept) {
  std::string text = text_of(session() / "measurements.csv");
  text.replace(text.find("\n1,0.0333333333,contact,0.75,100"), 32, "\n1,0.0333333333,contact,0.75,109");
  put(session() / "measurements.csv", text);
  const ExportReport exported = export_session(session(), other());
  EXPECT_TRUE(mentions(exported.notes, "1 row(s) left out")) << testing::PrintToString(exported.notes);
  expect_mended(session(), "measurements.csv:3: its checksum is wrong");
  EXPECT_TRUE(
      mentions(lines_of(session() / "damaged/lines.txt"), "measurements.csv:3: 1,0.0333333333,contact,0.75,109"));
  EXPECT_EQ(text_of(session() / "damaged/measurements.csv"), text);
}

TEST_F(SessionDamage, AnotherSessionsSurfaceIsNamed) {
  {
    SessionWriter writer(other(), make_info());
    for (long frame = 0; frame < 3; ++frame) {
      Scene scene = make_scene(frame);
      auto surface = scene.surface.shallow_copy();
      vtkNew<vtkPoints> points;
      points->DeepCopy(surface->GetPoints());
      points->SetPoint(1, 11.0, 0.0, 0.0);
      surface->SetPoints(points);
      scene.surface = Frozen(vtkSmartPointer<vtkPolyData>(surface));
      writer.write(scene);
    }
    writer.close();
  }
  const char* name = "surface/surface_00000001.vtp";
  fs::copy_file(other() / name, session() / name, fs::copy_options::overwrite_existing);
  expect_mended(session(), std::string(name) + ": damaged (its checksum is not the one in checksums.csv)");
}

TEST_F(SessionDamage, AChangedHeadIsNamedAndItsTextKept) {
  std::string text = text_of(session() / "session.json");
  text.replace(text.find("0.49"), 4, "0.94");
  put(session() / "session.json", text);
  EXPECT_TRUE(SessionReader(session()).head_changed());
  EXPECT_TRUE(mentions(export_session(session(), other()).notes, "session.json was changed"));
  expect_mended(session(), "session.json: was changed after it was written");
  EXPECT_EQ(text_of(session() / "damaged/session.json"), text);
  EXPECT_NE(text_of(session() / "session.json").find("0.94"), std::string::npos);
}

TEST_F(SessionDamage, AHeadWithoutItsChecksumIsNamed) {
  std::string text = text_of(session() / "session.json");
  text.replace(text.find("\"crc32\""), 7, "\"crc33\"");
  put(session() / "session.json", text);
  expect_mended(session(), "session.json: was changed after it was written");
}

TEST_F(SessionDamage, ADoubledEntryOfTheListIsNamed) {
  std::string text = text_of(session() / "session.pvd");
  const auto begin = text.find("<DataSet");
  const std::string entry = text.substr(begin, text.find('\n', begin) + 1 - begin);
  put(session() / "session.pvd", text.insert(begin, entry));
  expect_mended(session(), "session.pvd: lists 1 file(s)");
}

TEST_F(SessionDamage, AChangedBitOfTheListIsNamed) {
  std::string text = text_of(session() / "session.pvd");
  text.replace(text.find("name=\"surface\""), 14, "name=\"surfacf\"");
  put(session() / "session.pvd", text);
  expect_mended(session(), "session.pvd: not readable as the list");
}

TEST_F(SessionDamage, LostChecksumsAreMadeAnew) {
  fs::remove(session() / "checksums.csv");
  expect_mended(session(), "checksums.csv is missing");
  EXPECT_EQ(read_checksums(session() / "checksums.csv").rows.size(), 12U);
  // A row that is damaged costs one checksum, not the file it was of.
  std::string text = text_of(session() / "checksums.csv");
  text.replace(text.find("frames/"), 7, "grames/");
  put(session() / "checksums.csv", text);
  expect_mended(session(), "checksums.csv: lacks 1 data file(s)");
  EXPECT_TRUE(fs::exists(session() / "frames/frame_00000000.vti"));
}

TEST_F(SessionDamage, ASessionWithoutChecksumsStaysReadable) {
  remove_checksums(session());
  const SessionReport report = check_session(session(), false);
  EXPECT_TRUE(report.fine()) << testing::PrintToString(report.problems);
  EXPECT_TRUE(mentions(report.notes, "written without checksums"));
  EXPECT_EQ(SessionReader(session()).steps().size(), 3U);
  EXPECT_NO_THROW(SessionReader(session()).load(2));
  EXPECT_EQ(lines_of(session() / "measurements.csv").size(), 4U);
  // A repair does not claim to know what was written.
  fs::remove(session() / "session.pvd");
  expect_mended(session(), "session.pvd is missing");
  EXPECT_FALSE(fs::exists(session() / "checksums.csv"));
}

TEST_F(SessionDamage, ALaterSchemaIsLeftAlone) {
  SessionHead head{.info = make_info()};
  std::string text = to_json(head);
  text.replace(text.find("\"schema_version\": 1"), 19, "\"schema_version\": 9");
  text.resize(text.rfind(",\n  \"crc32\""));
  put(session() / "session.json", text + "\n}\n");
  put(session() / "measurements.csv", "torn");
  EXPECT_THROW(check_session(session(), true), InputError);
  EXPECT_EQ(text_of(session() / "measurements.csv"), "torn");
}

// Numbers that no measurement has, whatever their checksum says.
TEST_F(SessionDamage, ImpossibleNumbersAreNamed) {
  for (const char* cells : {"9,0.3,contact,1.75,", "9,0.3,contact,nan,", "9,1e999,contact,0.5,", "9,0.3,kontact,0.5,",
                            "99999999999999999999,0.3,contact,0.5,", "-9,0.3,contact,0.5,"}) {
    const std::string row = std::string(cells) + ",,,,,,,,,,,,,,,,,,,";
    write_session(other(), 1);
    std::ofstream(other() / "measurements.csv", std::ios::app) << signed_row(row) << '\n';
    EXPECT_TRUE(mentions(check_session(other(), false).problems, "measurements.csv:3")) << row;
    fs::remove_all(other());
  }
}

}  // namespace
}  // namespace pellucida
