#include "alate/study/study.hpp"
#include "out/output_folder.hpp"

namespace alate {

StudyFolder::StudyFolder(const std::string& folder) : output_(std::make_unique<OutputFolder>(folder)) {}
StudyFolder::~StudyFolder() = default;

std::vector<std::string> StudyFolder::write(const Study& study, const StudyRecords& records) {
  output_->write("study.html", study_html(study, records));
  output_->write("summary.md", summary_markdown(study, records));
  output_->write("rows.csv", rows_csv(study, records));
  output_->write("times.csv", times_csv(study, records));
  output_->publish();
  return {"study.html", "summary.md", "rows.csv", "times.csv"};
}

}  // namespace alate
