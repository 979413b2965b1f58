#include "pellucida/teleoperation/EppendorfProtocol.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace pellucida {
namespace {

constexpr long kLargestNumber = 1'000'000'000;  // far beyond any travel; a longer one is noise

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Whole numbers separated by spaces, signs or both; false when anything else is there.
bool read_numbers(std::string_view text, EppendorfAnswer& answer) noexcept {
  answer.number_count = 0;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const bool negative = text.front() == '-';
    if (negative || text.front() == '+') text.remove_prefix(1);
    if (text.empty() || !is_digit(text.front()) || answer.number_count == EppendorfAnswer::kMaxNumbers) return false;
    long value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || value > kLargestNumber) return false;
    answer.numbers[answer.number_count++] = negative ? -value : value;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && text.front() != ' ' && text.front() != '+' && text.front() != '-') return false;
  }
  return true;
}

std::string code_name(EppendorfCode code) {
  char name[16];
  std::snprintf(name, sizeof name, "C%03d", static_cast<int>(code));
  return name;
}

}  // namespace

std::string eppendorf_command(EppendorfCode code) {
  return code_name(code) + '\r';
}

std::string eppendorf_go_to(EppendorfCode code, const std::array<long, 3>& position, const std::array<long, 3>& speed) {
  std::string line = code_name(code);
  for (const long value : position) line += ' ' + std::to_string(value);
  for (const long value : speed) line += ' ' + std::to_string(value);
  return line + '\r';
}

std::optional<EppendorfAnswer> eppendorf_answer(std::string_view line) {
  line = trimmed(line);
  if (line.size() < 4 || line[0] != 'A' || !std::all_of(line.begin() + 1, line.begin() + 4, is_digit)) return {};
  if (line.size() > 4 && line[4] != ' ' && line[4] != '+' && line[4] != '-') return {};
  EppendorfAnswer answer;
  answer.code = (line[1] - '0') * 100 + (line[2] - '0') * 10 + (line[3] - '0');
  answer.text = trimmed(line.substr(4));
  if (!read_numbers(answer.text, answer)) answer.number_count = 0;
  return answer;
}

std::optional<EppendorfPosition> eppendorf_position(const EppendorfAnswer& answer) {
  if (answer.number_count != 4) return {};
  return EppendorfPosition{{answer.numbers[0], answer.numbers[1], answer.numbers[2]}, answer.numbers[3]};
}

void LineSplitter::push(std::string_view bytes) {
  for (const char byte : bytes) {
    const bool end = byte == '\r' || byte == '\n';
    if (dropping_) {
      dropping_ = !end;
      continue;
    }
    bytes_ += end ? '\n' : byte;
    // The line being written has no end yet: how long is it?
    const std::size_t start = bytes_.rfind('\n') + 1;
    if (bytes_.size() - start > kMaxLength) {
      bytes_.resize(start);
      dropping_ = true;
      ++dropped_count_;
    }
  }
}

std::optional<std::string> LineSplitter::next() {
  while (true) {
    const std::size_t end = bytes_.find('\n');
    if (end == std::string::npos) return {};
    std::string line = bytes_.substr(0, end);
    bytes_.erase(0, end + 1);
    if (!line.empty()) return line;
  }
}

void LineSplitter::clear() noexcept {
  bytes_.clear();
  dropping_ = false;
}

}  // namespace pellucida
