#include "out/report/svg.hpp"

#include <fmt/core.h>

#include <iterator>
#include <span>

#include "out/text.hpp"

namespace alate {

namespace {

std::string list_of(const std::vector<Vec2>& points) {
  std::string list;
  for (const Vec2& p : points) fmt::format_to(std::back_inserter(list), "{:.1f},{:.1f} ", p.x(), p.y());
  return list;
}

const char* word(Anchor anchor) {
  switch (anchor) {
    case Anchor::start:
      return "start";
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      break;
  }
  return "end";
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title) : width_(width), height_(height), title_(title) {}

void Svg::line(const Vec2& a, const Vec2& b, std::string_view css_class) {
  body_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" class="{}"/>)", a.x(), a.y(), b.x(),
                       b.y(), css_class);
  body_ += '\n';
}

void Svg::polyline(const std::vector<Vec2>& points, std::string_view css_class) {
  body_ += fmt::format("<polyline points=\"{}\" class=\"{}\"/>\n", list_of(points), css_class);
}

void Svg::shape(std::string_view opening, std::string_view name, std::string_view tooltip) {
  if (tooltip.empty())
    body_ += fmt::format("{}/>\n", opening);
  else
    body_ += fmt::format("{}><title>{}</title></{}>\n", opening, xml_escape(tooltip), name);
}

void Svg::polygon(const std::vector<Vec2>& points, std::string_view css_class, std::string_view tooltip) {
  shape(fmt::format(R"(<polygon points="{}" class="{}")", list_of(points), css_class), "polygon", tooltip);
}

void Svg::circle(const Vec2& center, double radius, std::string_view css_class, std::string_view tooltip) {
  shape(fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" class="{}")", center.x(), center.y(), radius,
                    css_class),
        "circle", tooltip);
}

void Svg::rect(const Vec2& corner, const Vec2& size, std::string_view css_class, std::string_view tooltip) {
  shape(fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" class="{}")", corner.x(), corner.y(),
                    size.x(), size.y(), css_class),
        "rect", tooltip);
}

void Svg::text(const Vec2& at, std::string_view text, std::string_view css_class, Anchor anchor) {
  body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\" text-anchor=\"{}\">{}</text>\n", at.x(), at.y(),
                       css_class, word(anchor), xml_escape(text));
}

void Svg::image(const Vec2& corner, const Vec2& size, const std::string& png, std::string_view css_class) {
  const auto bytes = std::as_bytes(std::span(png));
  body_ += fmt::format(
      "<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" preserveAspectRatio=\"none\" class=\"{}\" "
      "href=\"data:image/png;base64,{}\"/>\n",
      corner.x(), corner.y(), size.x(), size.y(), css_class, base64(bytes));
}

void Svg::begin_clip(const Vec2& corner, const Vec2& size) {
  body_ += fmt::format(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} {1:.1f} {2:.1f} "
      "{3:.1f}\">\n",
      corner.x(), corner.y(), size.x(), size.y());
}

void Svg::end_clip() { body_ += "</svg>\n"; }

std::string Svg::str() const {
  return fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\"><title>{}</title>\n{}</svg>\n", width_, height_,
                     xml_escape(title_), body_);
}

}  // namespace alate
