// alate schema: what scenario files may hold, for machines and for people.
#include <fmt/core.h>

#include <memory>

#include "alate/data/scenario_file.hpp"
#include "commands.hpp"

namespace alate::cli {

void add_schema(CLI::App& app, Command& chosen) {
  const auto markdown = std::make_shared<bool>(false);
  CLI::App& command = *add_command(app, "schema", "Print the JSON Schema of scenario files, or their manual",
                                   "alate schema --markdown > scenario.md");
  command.add_flag("--markdown", *markdown, "print the manual instead");
  command.callback([&chosen, markdown] {
    chosen = [markdown](const FaultList& faults) {
      faults.throw_if_any();
      const std::string text = *markdown ? scenario_manual() : scenario_json_schema();
      fmt::print("{}{}", text, text.ends_with('\n') ? "" : "\n");
      return kDone;
    };
  });
}

}  // namespace alate::cli
