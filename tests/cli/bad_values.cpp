#include "bad_values.hpp"

namespace cli {

const std::vector<Bad>& badSea() {
  static const std::vector<Bad> list{
      {"--wind", {"nan", "-inf", "-1", "0.09", "60.1", "1e999", "8m", "''"}, "0.1 to 60 m/s"},
      {"--wind-direction", {"nan", "361", "-361", "north"}, "-360 to 360 degrees"},
      {"--fetch", {"nan", "inf", "0", "10001"}, "0.1 to 10000 km"},
      {"--depth", {"nan", "-inf", "0.4", "deep"}, "0.5 to inf m"},
      {"--spectrum",
       {"JONSWAP", "table"},
       "phillips, pierson-moskowitz, jonswap, tma, elfouhaily, or a measured one: FILE.csv"},
      {"--spectrum", {"missing.csv"}, "a file that can be read"},
      {"--spreading", {"cos4"}, "cos2, mitsuyasu, hasselmann, donelan-banner, elfouhaily"},
      {"--swell-sharpening", {"nan", "-0.1", "1.1"}, "0 to 1"},
      {"--octave-gain",
       {"1", "1,1,1,1,1,1,1,1,1,1,1,x", "1,1,1,1,1,1,1,1,1,1,1,11"},
       "12 numbers with commas, each 0 to 10"},
      {"--swell", {"0,10,0", "21,10,0", "nan,10,0"}, "more than 0 to 20 m"},
      {"--swell", {"1,0.9,0", "1,31,0", "1,x,0"}, "1 to 30 s"},
      {"--swell", {"1,10,400", "1,10,inf"}, "-360 to 360 degrees"},
      {"--swell", {"1,10,0,0", "1,10,0,201"}, "1 to 200"},
      {"--swell", {"1,10", "1,10,0,20,5"}, "HS_M,TP_S,DEG"},
      {"--trochoid", {"0,50,0", "21,50,0", "nan,50,0"}, "more than 0 to 20 m"},
      {"--trochoid", {"1,0,0", "1,1e6,0"}, "more than 0 to 100000 m"},
      {"--trochoid", {"1,50,0,-1", "1,50,0,101"}, "0 to 100"},
      {"--trochoid", {"1,50", "1,50,0,1,0,0"}, "AMPLITUDE_M,LENGTH_M,DEG"},
      {"--pick-trochoids", {"257", "-1", "1.5"}, "whole numbers from 0 to 256"},
      {"--pick-trochoids", {"8,1.1", "8,0,nan"}, "0 to 1"},
      {"--gain-map", {"missing.exr,0,0,10"}, "an image"},
      {"--gain-map", {"missing.exr", "a,b"}, "FILE,X_M,Z_M,SPACING_M"},
      {"--choppiness", {"-0.1", "2.1", "nan"}, "0 to 2"},
      {"--asymmetry", {"-0.1", "2.1", "nan"}, "0 to 2"},
      {"--seed", {"-1", "1.5", "18446744073709551616"}, "whole numbers from 0 to 18446744073709551615"},
      {"--loop", {"0.9", "4194305", "nan"}, "1 to 4194304 s"},
      {"--cascades", {"0", "9", "2.5"}, "whole numbers from 1 to 8"},
      {"--span", {"-1", "nan", "100001"}, "0 to 100000 m"},
      {"--warp", {"-0.01", "nan", "0.11"}, "0 to 0.1"},
      {"--size", {"100", "32", "2048", "-64"}, "64, 128, 256, 512, 1024"},
      {"--sea", {"missing.toml", "/", "''"}, ""},
  };
  return list;
}

const std::vector<Bad>& badTime() {
  static const std::vector<Bad> list{
      {"--time", {"nan", "1e10", "-1e10"}, "-1000000000 to 1000000000 s"},
      {"--frames", {"0", "1.5", "1000001"}, "whole numbers from 1 to 1000000"},
      {"--fps", {"0", "nan", "1001"}, "more than 0 to 1000 1/s"},
  };
  return list;
}

std::vector<std::string> answer(const Bad& bad, const std::string& value) {
  return {bad.option, value == "''" ? value : "'" + value + "'", "allowed: ", value == "''" ? "" : bad.allowed};
}

}  // namespace cli
