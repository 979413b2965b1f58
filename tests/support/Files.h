#pragma once
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pellucida::test {

/// A file's whole content.
inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Makes `text` a file's whole content.
inline void put(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace pellucida::test
