#include "commands/Manual.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace pellucida {
namespace {

/// Text as troff takes it: hyphens are meant as they are typed, and a line must not begin as a request does.
std::string troff(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '\\') {
      escaped += "\\e";
    } else if (character == '-') {
      escaped += "\\-";
    } else if ((character == '.' || character == '\'') && (escaped.empty() || escaped.back() == '\n')) {
      escaped += "\\&";
      escaped += character;
    } else {
      escaped += character;
    }
  }
  return escaped;
}

void add_option(std::ostream& page, const CLI::Option& option, const CLI::Formatter& help) {
  page << ".TP\n\\fB" << troff(help.make_option_name(&option, option.get_positional())) << "\\fR"
       << troff(help.make_option_opts(&option)) << '\n'
       << troff(help.make_option_desc(&option)) << '\n';
}

}  // namespace

std::string manual_of_commands(const CLI::App& app) {
  const CLI::Formatter help;
  std::ostringstream page;
  for (const CLI::App* command : app.get_subcommands({})) {
    const auto options = command->get_options(
        [&](const CLI::Option* option) { return !option->get_group().empty() && option != command->get_help_ptr(); });
    page << ".SS " << troff(command->get_name()) << '\n' << troff(command->get_description()) << '\n';
    for (const CLI::Option* option : options) add_option(page, *option, help);
  }
  return page.str();
}

}  // namespace pellucida
