#include "SessionJson.h"

#include <nlohmann/json.hpp>

#include "TestSession.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using namespace test;

TEST(SessionJson, KeepsEverything) {
  const TemporaryFolder folder;
  SessionHead head{.info = make_info(), .options = {.frames = false}, .created = "2026-01-02T03:04:05Z"};
  head.info.source.live = true;
  head.info.source.bit_depth = 16;
  head.info.palpation_json = R"({"cell_scale_ratio":1.25,"puncture_risk":[]})";
  head.counts.step_count = 7;
  head.counts.file_count = {1, 2, 3, 4};
  head.counts.dropped_count = 9;
  head.counts.byte_count = 5'000'000'000ULL;
  put(folder / "session.json", to_json(head));
  const SessionHead read = read_session_json(folder / "session.json");
  EXPECT_EQ(to_json(read), to_json(head));
  EXPECT_EQ(read.counts.files(SessionPart::kFrame), 4U);
  EXPECT_EQ(read.counts.byte_count, 5'000'000'000ULL);
  EXPECT_TRUE(read.info.source.live);
  EXPECT_EQ(read.info.palpation_json, head.info.palpation_json);
  EXPECT_FALSE(read.options.frames);
}

TEST(SessionJson, UnknownAndMissingKeysAreNoError) {
  const TemporaryFolder folder;
  put(folder / "session.json", R"({"schema_version": 1, "news": [1, 2], "source": {"name": "x"}})");
  const SessionHead read = read_session_json(folder / "session.json");
  EXPECT_EQ(read.info.source.name, "x");
  EXPECT_FALSE(read.complete);
  EXPECT_TRUE(read.info.profile_json.empty());
}

TEST(SessionJson, WrongTypesAreAnInputError) {
  const TemporaryFolder folder;
  for (const char* text :
       {R"({"complete": "yes"})", R"({"counts": {"steps": "many"}})", R"({"source": 5})", "[1]", ""}) {
    put(folder / "session.json", text);
    EXPECT_THROW(read_session_json(folder / "session.json"), InputError) << text;
  }
}

TEST(SessionJson, ALaterSchemaIsNamedAndRefused) {
  const TemporaryFolder folder;
  put(folder / "session.json", R"({"schema_version": 99})");
  EXPECT_THROW(read_session_json(folder / "session.json"), LaterSchemaError);
  put(folder / "session.json", R"({"complete": true})");
  EXPECT_THROW(read_session_json(folder / "session.json"), InputError);
}

TEST(SessionJson, ImpossibleValuesAreAnInputError) {
  const TemporaryFolder folder;
  for (const char* text :
       {R"("calibration": {"pixel_size_um": -1})", R"("calibration": {"pixel_size_um": 1e300})",
        R"("source": {"width_px": -5})", R"("source": {"bit_depth": 12})", R"("source": {"frame_rate_hz": -2})"}) {
    put(folder / "session.json", std::string(R"({"schema_version": 1, )") + text + '}');
    EXPECT_THROW(read_session_json(folder / "session.json"), InputError) << text;
  }
}

TEST(SessionJson, DeepNestingIsRefused) {
  const TemporaryFolder folder;
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  put(folder / "session.json", R"({"schema_version": 1, "profile": {"content": )" + deep + "}}");
  EXPECT_THROW(read_session_json(folder / "session.json"), InputError);
}

TEST(SessionJson, EveryChangedBitIsSeen) {
  const TemporaryFolder folder;
  const std::string text = to_json({.info = make_info()});
  EXPECT_TRUE(nlohmann::json::accept(text));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
    put(folder / "session.json", changed);
    try {
      const SessionHead head = read_session_json(folder / "session.json");
      EXPECT_TRUE(head.changed || !head.checked) << "byte " << i;
    } catch (const InputError&) {
    }
  }
}

TEST(SessionJson, ARepairKeepsTheKeysOfLaterVersions) {
  const TemporaryFolder folder;
  put(folder / "session.json", R"({"schema_version": 1, "news": [1, 2], "counts": {"steps": 9}})");
  put(folder / "session.json", repaired_json(folder / "session.json", {.step_count = 4}));
  const auto json = nlohmann::json::parse(text_of(folder / "session.json"));
  EXPECT_EQ(json["news"], nlohmann::json({1, 2}));
  EXPECT_EQ(json["counts"]["steps"], 4);
  EXPECT_EQ(json["recovered"], true);
  EXPECT_FALSE(read_session_json(folder / "session.json").changed);
}

TEST(SessionJson, NameThatIsNoUtf8IsWrittenAllTheSame) {
  SessionHead head{.info = make_info()};
  head.info.source.name = "caf\xE9.avi";
  EXPECT_NE(to_json(head).find("caf"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
