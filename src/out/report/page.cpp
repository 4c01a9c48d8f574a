#include "out/report/page.hpp"

#include <fmt/core.h>

#include "out/report/style.hpp"
#include "out/text.hpp"

namespace alate {

std::string html_page(std::string_view title, std::string_view body, std::string_view extra_style) {
  constexpr std::string_view kPage = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:"/>
<title>{}</title>
<style>{}{}</style>
</head>
<body>
<main>
{}</main>
</body>
</html>
)";
  return fmt::format(kPage, xml_escape(title), kStyle, extra_style, body);
}

std::string page_section(std::string_view title, std::string_view content) {
  return content.empty() ? "" : fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", title, content);
}

}  // namespace alate
