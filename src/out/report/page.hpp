// The frame that every page of ours has: no scripts, nothing loaded from outside.
#pragma once

#include <string>
#include <string_view>

namespace alate {

/// Valid HTML that is also well-formed XML, with the style sheet of the report and `extra_style` after it. `title` is
/// escaped, `body` is HTML already.
std::string html_page(std::string_view title, std::string_view body, std::string_view extra_style = {});

/// Heading and content; empty for no content. Both are HTML already.
std::string page_section(std::string_view title, std::string_view content);

}  // namespace alate
