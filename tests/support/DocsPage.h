#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace pellucida {

inline std::string docs_page(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(PELLUCIDA_SOURCE_DIR "/docs/" + name).rdbuf();
  return text.str();
}

/// The section of a page in `docs` below the line `heading`, up to the next "## " or the end.
inline std::string docs_section(const std::string& name, const std::string& heading) {
  const std::string page = docs_page(name);
  const auto start = page.find(heading + '\n');
  if (start == std::string::npos) return "";
  const auto body = start + heading.size() + 1;
  return page.substr(body, page.find("\n## ", body) - body);
}

/// Whether that section, the page's last, is `expected`. With PELLUCIDA_WRITE_DOCS=1 in the environment it's written
/// so.
inline testing::AssertionResult docs_section_is(const std::string& name, const std::string& heading,
                                                const std::string& expected) {
  const std::string wanted = '\n' + expected;
  if (docs_section(name, heading) == wanted) return testing::AssertionSuccess();
  if (const char* write = std::getenv("PELLUCIDA_WRITE_DOCS"); write && std::string(write) == "1") {
    const std::string page = docs_page(name);
    std::ofstream(PELLUCIDA_SOURCE_DIR "/docs/" + name) << page.substr(0, page.find(heading)) << heading << '\n'
                                                        << wanted;
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "docs/" << name << ", \"" << heading
                                     << "\", differs from the table of fields; write it anew by running this test with "
                                        "PELLUCIDA_WRITE_DOCS=1. Expected:\n"
                                     << expected;
}

}  // namespace pellucida
