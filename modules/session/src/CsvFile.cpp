#include "CsvFile.h"

#include <cerrno>

#include "DiskFile.h"

namespace pellucida {

CsvFile::CsvFile(const std::filesystem::path& file, std::string_view header)
    : file_(file), temporary_(file.string() + kTemporarySuffix) {
  errno = 0;
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw disk_error(file_, errno);
  add(header);
}

CsvFile::~CsvFile() {
  std::error_code status;
  std::filesystem::remove(temporary_, status);
}

void CsvFile::add(std::string_view line) {
  // A full disk shows at the first write that fails: its reason is gone later.
  errno = 0;
  stream_.write(line.data(), static_cast<std::streamsize>(line.size()));
  stream_.put('\n');
  if (!stream_) throw disk_error(file_, errno);
}

void CsvFile::finish() {
  errno = 0;
  stream_.close();
  if (!stream_) throw disk_error(file_, errno);
  std::error_code reason;
  std::filesystem::rename(temporary_, file_, reason);
  if (reason) throw disk_error(file_, reason.value());
}

}  // namespace pellucida
