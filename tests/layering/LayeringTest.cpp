#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

// Reads the #include lines of the tree and holds them against layering.json and the rules for third-party headers.

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = PELLUCIDA_SOURCE_DIR;

struct Include {
  fs::path file;
  std::string header;
};

bool is_code(const fs::path& file) {
  const auto extension = file.extension();
  return extension == ".h" || extension == ".cpp" || extension == ".cxx";
}

// Parts of their own inside another: the windows of single modes, what measures speed.
const std::map<std::string, std::string> kInside = {{"guide", "ui"},    {"notes", "ui"},  {"readouts", "ui"},
                                                    {"recorded", "ui"}, {"review", "ui"}, {"start", "ui"},
                                                    {"teach", "ui"},    {"bench", "app"}};

bool is_inner_part(const fs::path& folder) {
  const auto inside = kInside.find(folder.filename());
  return inside != kInside.end() && folder.parent_path() == kRoot / inside->second;
}

// Below `folder`, but not in a part of its own inside it.
std::vector<fs::path> code_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
    if (entry->is_directory() && is_inner_part(entry->path())) entry.disable_recursion_pending();
    if (entry->is_regular_file() && is_code(entry->path())) files.push_back(entry->path());
  }
  return files;
}

std::vector<Include> includes_below(const fs::path& folder) {
  static const std::regex kLine(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
  std::vector<Include> found;
  for (const fs::path& file : code_below(folder)) {
    std::ifstream stream(file);
    std::string line;
    std::smatch match;
    while (std::getline(stream, line)) {
      if (std::regex_search(line, match, kLine)) found.push_back({file, match[1]});
    }
  }
  return found;
}

// "pellucida/core_vtk/Scene.h" belongs to core; other headers to nothing.
std::string part_of(const std::string& header) {
  static const std::regex kOurs(R"(^pellucida/([a-z]+)(_vtk)?/)");
  std::smatch match;
  return std::regex_search(header, match, kOurs) ? match[1].str() : "";
}

fs::path folder_of(const std::string& part) {
  if (const auto inside = kInside.find(part); inside != kInside.end()) return kRoot / inside->second / part;
  return part == "ui" || part == "app" ? kRoot / part : kRoot / "modules" / part;
}

std::map<std::string, std::set<std::string>> allowed_parts() {
  std::ifstream stream(kRoot / "tests" / "layering" / "layering.json");
  std::map<std::string, std::set<std::string>> allowed;
  const auto listed = nlohmann::json::parse(stream);
  for (const auto& [part, uses] : listed.items()) {
    if (part.starts_with("_")) continue;
    for (const auto& use : uses) allowed[part].insert(use.get<std::string>());
    allowed[part].insert(part);
  }
  return allowed;
}

TEST(Layering, EveryPartIsListed) {
  const auto allowed = allowed_parts();
  for (const auto& entry : fs::directory_iterator(kRoot / "modules")) {
    EXPECT_TRUE(!entry.is_directory() || allowed.contains(entry.path().filename())) << entry.path();
  }
}

TEST(Layering, IncludesPointDownward) {
  int checked_count = 0;
  for (const auto& [part, uses] : allowed_parts()) {
    for (const auto& include : includes_below(folder_of(part))) {
      const std::string used = part_of(include.header);
      if (used.empty()) continue;
      ++checked_count;
      EXPECT_TRUE(uses.contains(used)) << include.file << " includes " << include.header << ": " << part
                                       << " may not use " << used;
    }
  }
  EXPECT_GT(checked_count, 100);
}

TEST(Layering, ThereAreNoCycles) {
  const auto allowed = allowed_parts();
  // Strike out parts that use only struck-out ones; what is left is a cycle.
  std::set<std::string> settled;
  for (std::size_t round = 0; round <= allowed.size(); ++round) {
    for (const auto& entry : allowed) {
      const std::string& part = entry.first;
      const bool free = std::all_of(entry.second.begin(), entry.second.end(),
                                    [&](const std::string& use) { return use == part || settled.contains(use); });
      if (free) settled.insert(part);
    }
  }
  EXPECT_EQ(settled.size(), allowed.size());
}

bool is_vtk(const std::string& header) {
  return std::regex_search(header, std::regex("^(vtk[A-Z]|QVTK)"));
}
bool is_qt(const std::string& header) {
  return std::regex_search(header, std::regex("^(Q[A-Z]|QVTK)"));
}
bool is_opencv(const std::string& header) {
  return header.starts_with("opencv2/");
}
bool is_itk(const std::string& header) {
  return header.starts_with("itk");
}

TEST(Layering, QtOnlyInTheWindowAndTheApp) {
  for (const auto& include : includes_below(kRoot / "modules")) {
    EXPECT_FALSE(is_qt(include.header)) << include.file << " includes " << include.header;
  }
}

TEST(Layering, OpenCvAndItkInNoPublicHeader) {
  for (const auto& include : includes_below(kRoot / "modules")) {
    const bool is_public = include.file.string().find("/include/") != std::string::npos;
    if (!is_public) continue;
    EXPECT_FALSE(is_opencv(include.header) || is_itk(include.header)) << include.file << " includes " << include.header;
  }
}

long line_count(const fs::path& file) {
  std::ifstream stream(file);
  long count = 0;
  for (std::string line; std::getline(stream, line);) ++count;
  return count;
}

constexpr long kMostLinesOfAFile = 400, kMostLinesOfAPart = 5000;
// Still to be split; the list may only get shorter.
const std::set<std::string> kLargeParts = {"tracking"};

TEST(Size, NoFileIsTooLongAndNoPartTooLarge) {
  for (const auto& [part, uses] : allowed_parts()) {
    long part_count = 0;
    for (const fs::path& file : code_below(folder_of(part))) {
      const long count = line_count(file);
      part_count += count;
      EXPECT_LE(count, kMostLinesOfAFile) << file;
    }
    EXPECT_GT(part_count, 0) << part;
    if (!kLargeParts.contains(part)) {
      EXPECT_LE(part_count, kMostLinesOfAPart) << part;
    }
  }
}

TEST(Layering, TheCoresSpeakNoVtk) {
  // The parts a real-time thread or the thread sanitizer's build uses: their main targets are free of VTK.
  for (const char* part : {"core", "mechanics", "reconstruction", "tracking"}) {
    for (const char* inside : {"include", "src"}) {
      for (const auto& include : includes_below(folder_of(part) / inside)) {
        EXPECT_FALSE(is_vtk(include.header)) << include.file << " includes " << include.header;
      }
    }
  }
}

}  // namespace
