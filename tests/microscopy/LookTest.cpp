#include "pellucida/microscopy/Look.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldTable.h"
#include "support/DocsPage.h"

namespace pellucida {
namespace {

TEST(Look, DefaultsAreInTheirRangesAndOnThePage) {
  Look look;
  EXPECT_NO_THROW(validate(look));
  EXPECT_TRUE(docs_section_is("looks.md", "## Keys", markdown(fields_of(look))));
}

TEST(Look, EveryShippedOneIsReadAndOnThePage) {
  const auto names = look_names();
  EXPECT_GE(names.size(), 12u);
  const std::string page = docs_page("looks.md");
  for (const std::string& name : names) {
    const Look look = load_look(name);
    EXPECT_EQ(look.name, name);
    EXPECT_FALSE(look.description.empty()) << name;
    EXPECT_NE(page.find("| `" + name + "` |"), std::string::npos) << name << " is not in docs/looks.md";
  }
}

TEST(Look, SaysWhatIsWrong) {
  const auto message_of = [](const char* text) -> std::string {
    try {
      parse_look(text, "test");
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message_of(R"({"contrast": {"kind": "polarised"}})"),
            "look 'test': contrast.kind is 'polarised'; allowed: bright-field, hoffman, dic, phase, dark-field");
  EXPECT_NE(message_of(R"({"needle": {"end": "blunt"}})").find("needle.end is 'blunt'"), std::string::npos);
  EXPECT_NE(message_of(R"({"contrast": {"blur": 1}})").find("contrast.blur is an unknown key"), std::string::npos);
  EXPECT_NE(message_of(R"({"camera": {"gamma": 9}})").find("camera.gamma is 9; allowed: 0.3 to 2"), std::string::npos);
  EXPECT_THROW(load_look("no-such-look"), UsageError);
}

}  // namespace
}  // namespace pellucida
