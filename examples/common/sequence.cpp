#include "sequence.hpp"

#include "failure.hpp"

namespace common {

std::vector<double> Sequence::times() const {
  if (frames == 0) return {time};
  std::vector<double> list(frames);
  for (std::uint64_t i = 0; i < frames; ++i) list[i] = static_cast<double>(first + i) / rate;
  return list;
}

Fields sequenceFields(Sequence& sequence, bool withFirst) {
  Fields fields{
      numberField("time", "S", "The moment", {-1e9, 1e9, "s"}, sequence.time),
      wholeField("frames", "N", "A sequence of this many frames", 1, 1000000,
                 [&sequence](std::uint64_t n) { sequence.frames = n; }),
      numberField("fps", "F", "Frames per second of a sequence", {0, 1000, "1/s", true}, sequence.rate),
  };
  if (withFirst) {
    fields.push_back(wholeField("first", "I", "Number of a sequence's first frame, at the time I / F", 0, 100000000,
                                [&sequence](std::uint64_t n) { sequence.first = n; }));
  }
  return fields;
}

void checkSequence(const Program& program, bool withFirst) {
  const auto text = [&](const char* name) { return program.app().get_option(name)->as<std::string>(); };
  const bool sequence = program.given("--frames");
  if (sequence && program.given("--time")) refuse("--time", text("--time"), "either --time or --frames");
  if (!sequence && program.given("--fps")) refuse("--fps", text("--fps"), "only with --frames");
  if (!sequence && withFirst && program.given("--first")) refuse("--first", text("--first"), "only with --frames");
}

}  // namespace common
