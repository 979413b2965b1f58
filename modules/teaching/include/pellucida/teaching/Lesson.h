#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/teaching/ReadoutComparison.h"
#include "pellucida/teaching/SnakeSetting.h"
#include "pellucida/teaching/TeachingParameters.h"

namespace pellucida {

/// An answer to a lesson's question, and what is said to whoever gives it.
struct LessonAnswer {
  std::string text;
  bool is_right = false;
  std::string explanation;
};

/// What a lesson is about.
enum class LessonPage {
  kCell,      ///< the cell to be poked
  kSnake,     ///< a snake on a picture
  kReadouts,  ///< a contour read in two ways
};
/// Throws UsageError that lists the names.
LessonPage lesson_page(const std::string& name);

/// A page of a course, read from JSON (docs/lessons.md).
struct Lesson {
  std::string name;  ///< of the file, without its ending
  int order = 0;     ///< in the list
  std::string title;
  std::string scenario;              ///< of the virtual microscope, to see the same in; empty: none
  std::string page = "cell";         ///< see `lesson_page`
  std::vector<std::string> text;     ///< paragraphs
  TeachingParameters setting;        ///< of the parameters when the lesson begins
  double hand_depth_um = -10.0;      ///< where the hand is then
  bool explains_tip = false;         ///< the forces on the node under the needle are shown
  SnakeSetting snake;                ///< on page kSnake
  ReadoutParameters readouts;        ///< on page kReadouts
  std::vector<std::string> to_do;    ///< steps
  std::vector<std::string> observe;  ///< what to look for
  std::string question;
  std::vector<LessonAnswer> answers;  ///< two to six, one of them right
};

/// The keys of a lesson's file that are single values, with meaning and range; docs/lessons.md is printed from them.
FieldList fields_of(Lesson& lesson);

/// Reads a lesson. Throws InputError with file, key and what is wrong.
Lesson read_lesson(const std::filesystem::path& file);

/// A shipped lesson by name, or one in a file (its path). Throws UsageError that names the known lessons when there is
/// neither, InputError when the file is damaged.
Lesson load_lesson(std::string_view name_or_file);

/// All shipped lessons in their order; `folder`: of the resources, for another language's.
std::vector<Lesson> all_lessons(std::string_view folder = "lessons");

}  // namespace pellucida
