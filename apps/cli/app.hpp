// The program: reads the command line, runs one command, turns every failure into an exit code.
#pragma once

namespace alate::cli {

/// Never throws. Returns an exit code of commands.hpp.
int run(int argc, const char* const* argv) noexcept;

}  // namespace alate::cli
