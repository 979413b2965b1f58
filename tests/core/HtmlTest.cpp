#include "pellucida/core/Html.h"

#include <gtest/gtest.h>

#include <limits>

namespace pellucida {
namespace {

TEST(Html, MarkupIsText) {
  EXPECT_EQ(html_text("<script>alert('a & \"b\"')</script>"),
            "&lt;script&gt;alert(&#39;a &amp; &quot;b&quot;&#39;)&lt;/script&gt;");
  EXPECT_EQ(html_text("a\x1b[31mred\n"), "a [31mred ");
}

TEST(Html, Utf8StaysAndOtherBytesAreReplaced) {
  EXPECT_EQ(html_text("\xC3\xA9t\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80"),
            "\xC3\xA9t\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80");
  const std::string bad = "\xEF\xBF\xBD";
  EXPECT_EQ(html_text("\xFF"), bad);
  EXPECT_EQ(html_text("\xC3"), bad);
  EXPECT_EQ(html_text("\xC0\xBC"), bad + bad);            // "<" in two bytes
  EXPECT_EQ(html_text("\xE0\x80\xBC"), bad + bad + bad);  // and in three
  EXPECT_EQ(html_text("\xED\xA0\x80"), bad + bad + bad);  // half a pair
  EXPECT_EQ(html_text("a\xE2\x82"), "a" + bad + bad);
}

TEST(Html, NumbersHaveThreeDigitsAndNoExponent) {
  const auto text = [](double value) { return fixed_number(value, decimals_of(value)); };
  EXPECT_EQ(text(7.456), "7.46");
  EXPECT_EQ(text(0.12345), "0.123");
  EXPECT_EQ(text(44.04), "44.0");
  EXPECT_EQ(text(123456.0), "123456");
  EXPECT_EQ(text(1e-9), "0.0000");
  EXPECT_EQ(fixed_number(-0.001, 2), "0.00");
  EXPECT_EQ(fixed_number(-0.006, 2), "-0.01");
  EXPECT_EQ(fixed_number(std::numeric_limits<double>::quiet_NaN(), 1), "–");
}

TEST(Html, LinksArePercentEncoded) {
  EXPECT_EQ(html_link("day 1/ä%#?.avi"), "day%201/%C3%A4%25%23%3F.avi");
}

TEST(Html, UnitsAreWrittenWithMicro) {
  EXPECT_EQ(unit_text("uN/um"), "\xC2\xB5N/\xC2\xB5m");
  EXPECT_EQ(unit_text("stiffness at 5 um"), "stiffness at 5 \xC2\xB5m");
  EXPECT_EQ(unit_text("pJ"), "pJ");
  EXPECT_EQ(unit_text("volume"), "volume");
}

}  // namespace
}  // namespace pellucida
