// A program of another maker as a child: started, listened to, and never trusted.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace alate {

struct PeerCall {
  std::vector<std::string> words;  ///< Program first.
  std::string input;               ///< What its standard input holds.
  double start_limit_s = 60;       ///< Until its first line,
  double limit_s = 1;              ///< and from there until it has ended.
};

enum class PeerEnding {
  finished,  ///< With exit code 0.
  aborted,   ///< By a signal of its own.
  failed,    ///< With another exit code, or not started at all.
  hung,      ///< Beyond a limit of time, and killed.
  rubbish,   ///< Said what is not understood, and killed.
  stopped    ///< Killed on request.
};

const char* to_string(PeerEnding ending);

struct PeerEnd {
  PeerEnding ending = PeerEnding::finished;
  std::string note;  ///< Which signal or exit code, and the last line of its standard error.
};

/// Gets a line of its standard output and the seconds since the start; false if it makes no sense.
using HearPeer = std::function<bool(const std::string& line, double elapsed_s)>;

/// Whatever the child does, this returns within the limits, and the child and its own children are gone.
PeerEnd call_peer(const PeerCall& call, const std::stop_token& stop, const HearPeer& hear);

}  // namespace alate
