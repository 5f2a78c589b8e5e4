#!/usr/bin/env bash
# Builds Pelagic and renders: ./run.sh [arguments of pelagic-render]. Without arguments: the default scene at 1280x720
# into build/ocean.png.
source "$(dirname "${BASH_SOURCE[0]}")/cmake/setup.sh"

configure release
cmake --build "$build" --target pelagic-render >&2
if (($#)); then
  exec "$build/bin/pelagic-render" "$@"
fi
"$build/bin/pelagic-render" --resolution 1280x720 --output "$build/ocean.png"
echo "wrote $build/ocean.png" >&2
