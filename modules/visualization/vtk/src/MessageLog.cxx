#include "pellucida/visualization_vtk/MessageLog.h"

#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

#include <cstdio>
#include <regex>

namespace pellucida {
namespace {

// VTK's text is "ERROR: In file.cxx, line 12\nvtkThing (0x55..): what\n\n": keeps "vtkThing: what" on one line.
std::string one_line(const char* text) {
  static const std::regex place(R"(^(ERROR|Warning|Generic Warning): In [^\n]*, line \d+\n?)");
  static const std::regex address(R"( ?\(0x[0-9a-f]+\))");
  static const std::regex breaks(R"(\s*\n\s*)");
  std::string line = std::regex_replace(std::string(text ? text : ""), place, "");
  line = std::regex_replace(line, address, "");
  line = std::regex_replace(line, breaks, " ");
  line.erase(line.find_last_not_of(' ') + 1);
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
