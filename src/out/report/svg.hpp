// Drawing as inline SVG. Colours and text sizes come from the page's style sheet by class, so that one drawing serves
// light, dark, print and small screens. All text is escaped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "alate/core/geometry.hpp"

namespace alate {

enum class Anchor { start, middle, end };

/// A drawing of fixed size in user units (x right, y down) that scales with the page. Points are rounded to 0.1.
class Svg {
 public:
  /// `title` is read out to those who cannot see the drawing.
  Svg(double width, double height, std::string_view title);

  double width() const { return width_; }
  double height() const { return height_; }

  void line(const Vec2& a, const Vec2& b, std::string_view css_class);
  void polyline(const std::vector<Vec2>& points, std::string_view css_class);
  void polygon(const std::vector<Vec2>& points, std::string_view css_class, std::string_view tooltip = {});
  void circle(const Vec2& center, double radius, std::string_view css_class, std::string_view tooltip = {});
  void rect(const Vec2& corner, const Vec2& size, std::string_view css_class, std::string_view tooltip = {});
  void text(const Vec2& at, std::string_view text, std::string_view css_class, Anchor anchor = Anchor::start);
  /// An embedded PNG, stretched to the rectangle.
  void image(const Vec2& corner, const Vec2& size, const std::string& png, std::string_view css_class);

  /// Everything drawn until `end_clip` is cut off at the rectangle.
  void begin_clip(const Vec2& corner, const Vec2& size);
  void end_clip();

  /// The whole element.
  std::string str() const;

 private:
  void shape(std::string_view opening, std::string_view name, std::string_view tooltip);

  double width_;
  double height_;
  std::string title_;
  std::string body_;
};

}  // namespace alate
