// Text that is safe inside other formats.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace alate {

/// For element content and quoted attributes of XML and HTML. Bytes that are not UTF-8 and characters that XML 1.0
/// does not allow become U+FFFD.
std::string xml_escape(std::string_view text);

/// Shortest decimal that reads back as the same number; empty for nothing and for numbers that are not finite.
std::string round_trip(const std::optional<double>& number);

/// A cell of CSV: quoted where a reader would take it for more than one, and never a formula.
std::string csv_cell(const std::string& text);

std::string base64(std::span<const std::byte> bytes);

}  // namespace alate
