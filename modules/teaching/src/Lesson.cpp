#include "pellucida/teaching/Lesson.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using LessonJson = nlohmann::ordered_json;

constexpr const char* kLessonFolder = "lessons";
constexpr const char* kLessonEnding = ".json";

constexpr FieldRange kAnyLessonText;
constexpr Field<Lesson> kLessonHead[] = {
    {"order", "", &Lesson::order, {0, 1000}, "its place in the list", FieldNeed::kRequired},
    {"title", "", &Lesson::title, kAnyLessonText, "one line", FieldNeed::kRequired},
    {"scenario", "", &Lesson::scenario, kAnyLessonText, "of the virtual microscope, in which the same can be seen"},
    {"page", "", &Lesson::page, kAnyLessonText, "what is shown: `cell`, `snake` or `readouts`"},
    {"hand_depth_um", "um", &Lesson::hand_depth_um, {-50, 100}, "where the hand is at the start; below 0: outside"},
    {"explains_tip", "", &Lesson::explains_tip, kAnyLessonText,
     "true: the forces on the node under the needle are shown"},
    {"question", "", &Lesson::question, kAnyLessonText, "asked at the end", FieldNeed::kRequired},
};
constexpr Field<LessonAnswer> kAnswer[] = {
    {"text", "", &LessonAnswer::text, kAnyLessonText, "the answer", FieldNeed::kRequired},
    {"right", "", &LessonAnswer::is_right, kAnyLessonText, "whether it is right", FieldNeed::kRequired},
    {"explanation", "", &LessonAnswer::explanation, kAnyLessonText, "why", FieldNeed::kRequired},
};

void check(const std::optional<std::string>& fault, const std::string& where) {
  if (fault) throw InputError(where + ": " + *fault);
}

std::vector<std::string> texts_of(const LessonJson& root, const char* key, const std::string& where) {
  const auto list = root.find(key);
  if (list == root.end() || !list->is_array() || list->empty()) {
    throw InputError(where + ": " + key + " must be a list of texts");
  }
  std::vector<std::string> texts;
  for (const LessonJson& text : *list) {
    if (!text.is_string()) throw InputError(where + ": " + key + " must be a list of texts");
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

// A group of keys that a page is set up by; the cell's must be there.
template <class Setting>
void read_group(const LessonJson& root, const char* key, bool required, const std::string& where, Setting& setting) {
  const auto json = root.find(key);
  if (json == root.end() && !required) return;
  const std::string place = where + ": " + key;
  if (json == root.end() || !json->is_object()) throw InputError(place + " must be a group of keys, {...}");
  check(read_fields(*json, fields_of(setting)), place);
  try {
    require_valid(setting);
  } catch (const UsageError& error) {
    throw InputError(place + ": " + error.what());
  }
}

void read_page(const LessonJson& root, const std::string& where, Lesson& lesson) {
  try {
    const LessonPage page = lesson_page(lesson.page);
    read_group(root, "setting", page == LessonPage::kCell, where, lesson.setting);
    read_group(root, "snake", page == LessonPage::kSnake, where, lesson.snake);
    read_group(root, "readouts", page == LessonPage::kReadouts, where, lesson.readouts);
  } catch (const UsageError& error) {
    throw InputError(where + ": " + error.what());
  }
}

void read_answers(const LessonJson& root, const std::string& where, std::vector<LessonAnswer>& answers) {
  const auto list = root.find("answers");
  if (list == root.end() || !list->is_array() || list->size() < 2 || list->size() > 6) {
    throw InputError(where + ": answers must be a list of two to six");
  }
  for (const LessonJson& json : *list) {
    const std::string place = where + ": answers[" + std::to_string(answers.size()) + ']';
    if (!json.is_object()) throw InputError(place + " must be a group of keys, {...}");
    LessonAnswer& answer = answers.emplace_back();
    check(read_fields(json, FieldList().add("", kAnswer, answer)), place);
  }
  const auto right = std::count_if(answers.begin(), answers.end(), [](const auto& answer) { return answer.is_right; });
  if (right != 1) throw InputError(where + ": answers: one of them must be right, not " + std::to_string(right));
}

}  // namespace

LessonPage lesson_page(const std::string& name) {
  if (name == "cell") return LessonPage::kCell;
  if (name == "snake") return LessonPage::kSnake;
  if (name == "readouts") return LessonPage::kReadouts;
  throw UsageError("page " + name + ": not known; known are cell, snake, readouts");
}

FieldList fields_of(Lesson& lesson) {
  FieldList list;
  list.add("", kLessonHead, lesson);
  return list;
}

Lesson read_lesson(const std::filesystem::path& file) {
  const LessonJson root = read_json_object(file);
  const std::string where = file.string();
  if (root.value("schema", LessonJson()) != "pellucida-lesson") {
    throw InputError(where + ": schema must be \"pellucida-lesson\"");
  }
  if (root.value("schema_version", LessonJson()) != 1) {
    throw InputError(where + ": schema_version must be 1; update the program or the file");
  }
  Lesson lesson;
  lesson.name = file.stem().string();
  check(read_fields(root, fields_of(lesson), UnknownKeys::kIgnored), where);
  check(range_fault(fields_of(lesson)), where);
  lesson.text = texts_of(root, "text", where);
  lesson.to_do = texts_of(root, "do", where);
  lesson.observe = texts_of(root, "observe", where);
  read_page(root, where, lesson);
  read_answers(root, where, lesson.answers);
  return lesson;
}

Lesson load_lesson(std::string_view name_or_file) {
  return read_lesson(find_resource(kLessonFolder, name_or_file, kLessonEnding));
}

std::vector<Lesson> all_lessons(std::string_view folder) {
  std::vector<Lesson> lessons;
  for (const std::string& name : list_resources(folder, kLessonEnding)) {
    lessons.push_back(read_lesson(find_resource(folder, name, kLessonEnding)));
  }
  std::stable_sort(lessons.begin(), lessons.end(), [](const auto& a, const auto& b) { return a.order < b.order; });
  return lessons;
}

}  // namespace pellucida
