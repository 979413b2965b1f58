#pragma once
#include <filesystem>
#include <fstream>
#include <string_view>

namespace pellucida {

/// A table written in one go: under its name it is whole or not there (an older one stays until then).
class CsvFile {
 public:
  /// Throws OutputError when it can't be made.
  CsvFile(const std::filesystem::path& file, std::string_view header);
  /// Without a `finish` before it, nothing is left behind.
  ~CsvFile();
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  void add(std::string_view line);

  /// Puts the table under its name. Throws OutputError when any of it couldn't be written.
  void finish();

 private:
  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
};

}  // namespace pellucida
