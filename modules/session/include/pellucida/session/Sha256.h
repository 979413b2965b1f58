#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace pellucida {

/// SHA-256 of bytes added one after another. One thread at a time.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void add(const void* bytes, std::size_t count);
  /// Of everything added so far, 64 hexadecimal digits; more may be added afterwards.
  std::string hex() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Of a text.
std::string sha256_of(std::string_view text);
/// Of a file's bytes, as `sha256sum` prints it. Throws InputError when it can't be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace pellucida
