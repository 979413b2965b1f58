#pragma once
#include <unistd.h>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "pellucida/core/Error.h"

namespace pellucida::test {

/// Lays `size` bytes down as a file of this process (the same for every call with the same `extension`) and gives it to
/// `read`. An `Error` is a reader's right; any other exception leaves here and ends the fuzzer.
template <class Read>
void fuzz_reader(const std::uint8_t* data, std::size_t size, std::string_view extension, Read read) {
  auto file = std::filesystem::temp_directory_path() / ("pellucida-fuzz-" + std::to_string(getpid()));
  file += extension;
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    read(file);
  } catch (const Error&) {
  }
}

}  // namespace pellucida::test
