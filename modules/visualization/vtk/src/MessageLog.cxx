#include "pellucida/visualization_vtk/MessageLog.h"

#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

#include <cctype>
#include <cstdio>
#include <string_view>

namespace pellucida {
namespace {

// VTK's text is "ERROR: In file.cxx, line 12\nvtkThing (0x55..): what\n\n": keeps "vtkThing: what" on one line.
std::string one_line(const char* text) {
  std::string_view rest = text ? text : "";
  for (const std::string_view kind : {"ERROR: In ", "Warning: In ", "Generic Warning: In "}) {
    const std::size_t end = rest.find('\n');
    if (rest.substr(0, kind.size()) == kind && end != std::string_view::npos) rest.remove_prefix(end + 1);
  }

  // Addresses differ from run to run; line ends and rows of spaces become one space.
  std::string line;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest.substr(i, 3) == "(0x") {
      const std::size_t end = rest.find(')', i);
      if (end != std::string_view::npos) {
        if (!line.empty() && line.back() == ' ') line.pop_back();
        i = end;
        continue;
      }
    }
    const bool space = std::isspace(static_cast<unsigned char>(rest[i])) != 0;
    if (space && (line.empty() || line.back() == ' ')) continue;
    line += space ? ' ' : rest[i];
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

}  // namespace

vtkStandardNewMacro(MessageLog);

MessageLog* MessageLog::install() {
  if (auto* log = MessageLog::SafeDownCast(vtkOutputWindow::GetInstance())) return log;
  auto log = vtkSmartPointer<MessageLog>::New();
  vtkOutputWindow::SetInstance(log);
  return log;
}

void MessageLog::take(const char* kind, const char* text) {
  const std::string line = one_line(text);
  if (line.empty()) return;
  ++problem_count_;
  last_problem_ = line;
  if (++seen_[line] == 1) std::fprintf(stderr, "vtk %s: %s\n", kind, line.c_str());
}

void MessageLog::DisplayText(const char* text) {
  take("message", text);
}
void MessageLog::DisplayErrorText(const char* text) {
  take("error", text);
}
void MessageLog::DisplayWarningText(const char* text) {
  take("warning", text);
}
void MessageLog::DisplayGenericWarningText(const char* text) {
  take("warning", text);
}

}  // namespace pellucida
