#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/session/Annotations.h"

namespace pellucida {

/// The annotations of one session, written to it at each change; every change can be undone and done again. A change
/// that can't be written throws OutputError and leaves everything as it was.
class NoteBook {
 public:
  /// Throws as `read_annotations`; the book is then closed, and the file is left alone.
  void open(const std::filesystem::path& session);
  void close();
  bool is_open() const noexcept { return !session_.empty(); }

  /// In the order of time.
  const std::vector<Annotation>& notes() const noexcept { return notes_; }
  /// Those at a time, to the millisecond.
  std::vector<std::size_t> at(double time_s) const;

  void add(const Annotation& note);
  void edit(std::size_t index, const std::string& text);
  void remove(std::size_t index);
  bool can_undo() const noexcept { return !before_.empty(); }
  bool can_redo() const noexcept { return !after_.empty(); }
  void undo();
  void redo();

 private:
  void change(std::vector<Annotation> notes);
  void step(std::vector<std::vector<Annotation>>& from, std::vector<std::vector<Annotation>>& to);

  std::filesystem::path session_;
  std::vector<Annotation> notes_;
  std::vector<std::vector<Annotation>> before_, after_;
};

/// "0.43 s, node 12", "0.43 s, at 120.0, 80.5 µm", "0.43 s".
std::string where_of(const Annotation& note);

}  // namespace pellucida
