#include "out/report/report.hpp"

#include <fmt/core.h>

#include "out/text.hpp"

namespace alate {

std::string report_html(const Result& result) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\"><head><meta charset=\"utf-8\"/>"
      "<title>alate</title></head><body><h1>{}</h1></body></html>\n",
      xml_escape(summary(result)));
}

}  // namespace alate
