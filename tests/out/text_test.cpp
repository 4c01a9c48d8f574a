#include "out/text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace alate {
namespace {

TEST(XmlEscape, HidesMarkup) {
  EXPECT_EQ(xml_escape("<script>alert('1 & \"2\"')</script>"),
            "&lt;script&gt;alert(&#39;1 &amp; &quot;2&quot;&#39;)&lt;/script&gt;");
}

TEST(XmlEscape, KeepsUtf8) { EXPECT_EQ(xml_escape("Flüela ⛰ 𝄞"), "Flüela ⛰ 𝄞"); }

TEST(XmlEscape, ReplacesWhatXmlForbids) {
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(xml_escape(std::string("a\0b", 3)), "a" + replaced + "b");
  EXPECT_EQ(xml_escape("\x1B[31m"), replaced + "[31m");
  EXPECT_EQ(xml_escape("\xFFx"), replaced + "x");
  EXPECT_EQ(xml_escape("\xE2\x82"), replaced + replaced);  // cut off
  EXPECT_EQ(xml_escape("\xC0\xBC"), replaced + replaced);  // overlong <
  EXPECT_EQ(xml_escape("\xED\xA0\x80"), replaced);         // surrogate
  EXPECT_EQ(xml_escape("\xEF\xBF\xBE"), replaced);         // U+FFFE
  EXPECT_EQ(xml_escape("tab\tline\n"), "tab\tline\n");
}

RC_GTEST_PROP(XmlEscape, LeavesNoMarkup, (const std::string& text)) {
  RC_ASSERT(xml_escape(text).find_first_of("<>\"'") == std::string::npos);
}

TEST(RoundTrip, WritesNothingForWhatIsNoNumber) {
  EXPECT_EQ(round_trip(std::nullopt), "");
  EXPECT_EQ(round_trip(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(round_trip(-std::numeric_limits<double>::infinity()), "");
  EXPECT_EQ(round_trip(-1.5), "-1.5");
}

RC_GTEST_PROP(RoundTrip, ReadsBackToTheSameBits, (double value)) {
  const std::string text = round_trip(value);
  double back = 0;
  std::from_chars(text.data(), text.data() + text.size(), back);
  RC_ASSERT(back == value);
}

TEST(Base64, KnowsTheVectorsOfRfc4648) {
  const auto encode = [](std::string_view text) { return base64(std::as_bytes(std::span(text))); };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace alate
