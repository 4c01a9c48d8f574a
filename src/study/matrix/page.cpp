#include "out/report/page.hpp"
#include "alate/study/study.hpp"
#include "out/text.hpp"
#include "study/page/study_style.hpp"

namespace alate {

std::string study_html(const Study& study, const StudyRecords& records) {
  return html_page("alate study: " + study.file, "<pre>" + xml_escape(to_text(study, records)) + "</pre>", kStudyStyle);
}

}  // namespace alate
