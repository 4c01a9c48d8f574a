#include "out/report/history_view.hpp"

#include <gtest/gtest.h>

namespace alate {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(HistoryView, WithoutHistoryThereIsNoFigure) { EXPECT_EQ(history_figure({}), ""); }

TEST(HistoryView, ShowsCostsAndShares) {
  const std::vector<IterationStats> history{
      {.best_so_far = 12, .best = 12, .mean = 14, .worst = 16, .arrived = 0.5, .known = 0},
      {.best_so_far = 10, .best = 10, .mean = 11, .worst = 13, .arrived = 1, .known = 0.25}};
  const std::string html = history_figure(history);
  for (const char* name : {"Best so far", "Best of the iteration", "Mean of the iteration", "Worst of the iteration",
                           "Routes found", "Moves onto a known trail"})
    EXPECT_NE(html.find(name), std::string::npos) << name;
  EXPECT_EQ(count(html, "<polyline"), 6U);
}

TEST(HistoryView, LinesAreBrokenWhereNoAntArrived) {
  std::vector<IterationStats> history(5);
  for (IterationStats& now : history) now.best_so_far = 10;
  for (const std::size_t i : {0U, 1U, 3U, 4U}) history[i].best = 10;
  const std::string html = history_figure(history);
  EXPECT_EQ(count(html, "class=\"ants best\""), 2U);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(HistoryView, OnlyAColonyHasTrails) {
  const std::string html = history_figure({{.best_so_far = 12, .arrived = 0.5}, {.best_so_far = 12, .arrived = 0.5}});
  EXPECT_NE(html.find("Routes found"), std::string::npos);
  EXPECT_EQ(html.find("trail"), std::string::npos);
}

TEST(HistoryView, AColonyWithoutAnyRouteIsDrawnToo) {
  const std::string html = history_figure(std::vector<IterationStats>(3, {.known = 0}));
  EXPECT_EQ(html.find("nan"), std::string::npos);
  EXPECT_EQ(html.find("inf"), std::string::npos);
  EXPECT_EQ(count(html, "<polyline"), 2U);
}

}  // namespace
}  // namespace alate
