/// Proof that the goldens are a gate: what is wrong by 2 % or one degree must fail against them.
#include <glm/gtc/constants.hpp>

#include "compare.hpp"
#include "draw.hpp"
#include "mutant_cascade.spv.hpp"
#include "mutant_foam_columns.spv.hpp"
#include "mutant_foam_history.spv.hpp"
#include "mutant_fresnel.spv.hpp"
#include "mutant_mirror.spv.hpp"
#include "right_composite_water_comp.spv.hpp"
#include "right_waves_columns_comp.spv.hpp"
#include "right_waves_foam_comp.spv.hpp"
#include "shader_swap.hpp"
#include "support/gpu_test.hpp"

namespace {

namespace shaders = pelagic::shaders;

constexpr double kOff = 1.02;
constexpr double kDegree = glm::pi<double>() / 180;

class Mutation : public support::GpuTest {
 protected:
  /// Draws `scene` with `swaps` in place and expects that it no longer passes for the golden `name`.
  void expectCaught(const std::string& name, const common::Scene& scene, std::vector<golden::Swap> swaps = {}) {
    const golden::ShaderSwap swap(gpu().info(), std::move(swaps));
    const golden::Picture wrong = golden::draw(gpu(), swap.handles(), scene);
    EXPECT_TRUE(swap.complete()) << "the library does not use the shader that was to be replaced";
    const auto findings = golden::compare(golden::readPng(golden::imageOf(name)), wrong);
    EXPECT_FALSE(findings.empty()) << "the goldens do not see this mistake";
    for (const std::string& finding : findings) std::cout << name << ": " << finding << '\n';
  }
};

TEST_F(Mutation, NothingWrongIsNotCaught) {
  // The same way through the replaced functions, with the right shader.
  const golden::ShaderSwap swap(gpu().info(),
                                {{shaders::right_composite_water_comp, shaders::right_composite_water_comp}});
  const golden::Picture right = golden::draw(gpu(), swap.handles(), golden::builtin("trade-wind"));
  EXPECT_TRUE(swap.complete());
  EXPECT_TRUE(golden::compare(golden::readPng(golden::imageOf("trade-wind")), right).empty());
}

TEST_F(Mutation, FresnelReflectance) {
  expectCaught("trade-wind", golden::builtin("trade-wind"),
               {{shaders::right_composite_water_comp, shaders::mutant_fresnel}});
}

TEST_F(Mutation, FoamThreshold) {
  expectCaught("gale", golden::builtin("gale"),
               {{shaders::right_waves_columns_comp, shaders::mutant_foam_columns},
                {shaders::right_waves_foam_comp, shaders::mutant_foam_history}});
}

TEST_F(Mutation, MirroredAxis) {
  expectCaught("trade-wind", golden::builtin("trade-wind"),
               {{shaders::right_waves_columns_comp, shaders::mutant_mirror}});
}

TEST_F(Mutation, MissingCascade) {
  expectCaught("trade-wind", golden::builtin("trade-wind"),
               {{shaders::right_waves_columns_comp, shaders::mutant_cascade}});
}

TEST_F(Mutation, WindDirection) {
  common::Scene scene = golden::builtin("trade-wind");
  scene.sea.state.windDirection += (kOff - 1) * 90 * kDegree;
  expectCaught("trade-wind", scene);
}

TEST_F(Mutation, Choppiness) {
  common::Scene scene = golden::builtin("fresh-overcast");
  scene.sea.state.choppiness *= kOff;
  expectCaught("fresh-overcast", scene);
}

TEST_F(Mutation, Extinction) {
  common::Scene scene = golden::builtin("trade-wind");
  scene.medium.absorption *= static_cast<float>(kOff);
  expectCaught("trade-wind", scene);
}

TEST_F(Mutation, SunHeight) {
  common::Scene scene = golden::builtin("sunset-glitter");
  scene.sky.sunElevation += kDegree;
  expectCaught("sunset-glitter", scene);
}

}  // namespace
