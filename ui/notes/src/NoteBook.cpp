#include "NoteBook.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kSameMoment_s = 5e-4;

}  // namespace

void NoteBook::open(const std::filesystem::path& session) {
  close();
  notes_ = read_annotations(session);
  session_ = session;
}

void NoteBook::close() {
  session_.clear();
  notes_.clear();
  before_.clear();
  after_.clear();
}

std::vector<std::size_t> NoteBook::at(double time_s) const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < notes_.size(); ++k) {
    if (std::abs(notes_[k].time_s - time_s) < kSameMoment_s) found.push_back(k);
  }
  return found;
}

void NoteBook::change(std::vector<Annotation> notes) {
  std::stable_sort(notes.begin(), notes.end(), [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  write_annotations(session_, notes);
  before_.push_back(std::exchange(notes_, std::move(notes)));
  after_.clear();
}

void NoteBook::add(const Annotation& note) {
  auto notes = notes_;
  notes.push_back(note);
  change(std::move(notes));
}

void NoteBook::edit(std::size_t index, const std::string& text) {
  auto notes = notes_;
  notes.at(index).text = text;
  change(std::move(notes));
}

void NoteBook::remove(std::size_t index) {
  auto notes = notes_;
  notes.erase(notes.begin() + static_cast<std::ptrdiff_t>(index));
  change(std::move(notes));
}

void NoteBook::step(std::vector<std::vector<Annotation>>& from, std::vector<std::vector<Annotation>>& to) {
  if (from.empty()) return;
  write_annotations(session_, from.back());
  to.push_back(std::exchange(notes_, std::move(from.back())));
  from.pop_back();
}

void NoteBook::undo() {
  step(before_, after_);
}

void NoteBook::redo() {
  step(after_, before_);
}

std::string where_of(const Annotation& note) {
  std::string where = readout::time(note.time_s);
  if (note.node) where += say(", node ") + std::to_string(*note.node);
  if (note.place_um) {
    where +=
        say(", at ") + readout::number(note.place_um->x_um, 1) + ", " + readout::number(note.place_um->y_um, 1) + " µm";
  }
  return where;
}

}  // namespace pellucida
