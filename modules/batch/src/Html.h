#pragma once
#include <string>
#include <string_view>

namespace pellucida {

/// `text` as content or as a quoted attribute of HTML and SVG.
std::string html_text(std::string_view text);
/// `path` as a link relative to the page.
std::string html_link(std::string_view path);
/// With so many digits behind the point; an en dash for NaN.
std::string html_number(double value, int digits);

}  // namespace pellucida
