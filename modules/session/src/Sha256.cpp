#include "pellucida/session/Sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

void require_digest(int result) {
  if (result != 1) throw Error(ExitCode::kOurFault, "SHA-256 failed in the cryptographic library");
}

}  // namespace

class Sha256::Impl {
 public:
  struct DigestDeleter {
    void operator()(EVP_MD_CTX* context) const noexcept { EVP_MD_CTX_free(context); }
  };
  using DigestContext = std::unique_ptr<EVP_MD_CTX, DigestDeleter>;

  Impl() : context_(new_context()) { require_digest(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)); }

  void add(const void* bytes, std::size_t count) { require_digest(EVP_DigestUpdate(context_.get(), bytes, count)); }

  std::string hex() const {
    // A copy is finished, so that more can be added to this one.
    const DigestContext copy = new_context();
    require_digest(EVP_MD_CTX_copy_ex(copy.get(), context_.get()));
    std::array<std::uint8_t, EVP_MAX_MD_SIZE> bytes{};
    unsigned count = 0;
    require_digest(EVP_DigestFinal_ex(copy.get(), bytes.data(), &count));
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (unsigned i = 0; i < count; ++i) {
      text += kDigits[bytes[i] >> 4U];
      text += kDigits[bytes[i] & 15U];
    }
    return text;
  }

 private:
  static DigestContext new_context() {
    DigestContext context(EVP_MD_CTX_new());
    if (!context) throw Error(ExitCode::kOurFault, "SHA-256: no memory");
    return context;
  }

  DigestContext context_;
};

Sha256::Sha256() : impl_(std::make_unique<Impl>()) {}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(const void* bytes, std::size_t count) {
  impl_->add(bytes, count);
}
std::string Sha256::hex() const {
  return impl_->hex();
}

std::string sha256_of(std::string_view text) {
  Sha256 sum;
  sum.add(text.data(), text.size());
  return sum.hex();
}

std::string sha256_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Sha256 sum;
  std::vector<char> block(std::size_t{1} << 20U);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0) {
    sum.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.eof()) throw InputError(file.string() + ": can't be read; check that it exists, and its permission");
  return sum.hex();
}

}  // namespace pellucida
