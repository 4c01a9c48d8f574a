#!/usr/bin/env bash
# From a fresh Debian 12 to a flight over real mountains: installs what is missing, builds, plans, says where to look.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source cmake/steps.sh

if (($# > 0)); then
  echo "usage: ./demo.sh" >&2
  exit 2
fi

install_missing cmake/packages.txt
configure release -DALATE_BUILD_TESTS=OFF
build release --target alate_cli

echo
build/release/bin/alate plan examples/jacksboro/scenario.yaml --out out/jacksboro
echo
echo "Look at the flight first: $PWD/out/jacksboro/report.html"
echo "The program:              $PWD/build/release/bin/alate --help"
