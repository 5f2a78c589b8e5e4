#include <pelagic/shader/sky_light.h>
#include <composite/targets.hpp>
#include <gpu/field.hpp>
#include <initializer_list>
#include <string>

namespace pelagic {
namespace {

std::string sizeOf(VkExtent2D extent) { return std::to_string(extent.width) + " x " + std::to_string(extent.height); }

Result<void> checkImage(const HostImage& image, const std::string& name, VkExtent2D extent,
                        std::initializer_list<VkFormat> formats) {
  if (image.image == VK_NULL_HANDLE || image.view == VK_NULL_HANDLE) return gpu::reject(name + " is null");
  std::string allowed;
  bool fits = false;
  for (const VkFormat format : formats) {
    fits = fits || image.format == format;
    allowed += (allowed.empty() ? "" : " or ") + vk::to_string(vk::Format(format));
  }
  if (!fits) {
    return gpu::reject(name + ".format is " + vk::to_string(vk::Format(image.format)) + ", it must be " + allowed);
  }
  if (image.extent.width != extent.width || image.extent.height != extent.height) {
    return gpu::reject(name + ".extent is " + sizeOf(image.extent) + ", it must be " + sizeOf(extent));
  }
  if (image.after.layout == VK_IMAGE_LAYOUT_UNDEFINED) return gpu::reject(name + ".after.layout is UNDEFINED");
  return {};
}

}  // namespace

std::span<const NamedWaterLook> waterLooks() noexcept {
  using Law = WaterLook::Law;
  static const NamedWaterLook looks[] = {
      {"natural", {}},
      {"turquoise", {.law = Law::deepShallow}},
      {"glassy", {.law = Law::thickness, .deep = {0.004f, 0.026f, 0.042f}}},
      {"painted", {.law = Law::viewAngle, .shallow = {0.012f, 0.060f, 0.055f}, .contrast = 1.6f}},
  };
  return looks;
}

Result<void> validate(const WaterMedium& medium) {
  const WaterLook& look = medium.look;
  if (look.law < WaterLook::Law::medium || look.law > WaterLook::Law::viewAngle) {
    return gpu::reject("WaterLook::law is " + std::to_string(static_cast<int>(look.law)) + ", it must be 0 to 3");
  }
  for (int i = 0; i < 3; ++i) {
    const std::string channel{'[', static_cast<char>('0' + i), ']'};
    PELAGIC_CHECK(
        gpu::check("WaterMedium::",
                   {{"absorption" + channel, medium.absorption[i], static_cast<double>(1e-4f), 100, "1e-4 to 100 1/m"},
                    {"backscatter" + channel, medium.backscatter[i], 0, 100, "0 to 100 1/m"}}));
    PELAGIC_CHECK(gpu::check("WaterLook::", {{"deep" + channel, look.deep[i], 0, 1, "0 to 1"},
                                             {"shallow" + channel, look.shallow[i], 0, 1, "0 to 1"}}));
  }
  PELAGIC_CHECK(gpu::check("WaterMedium::", {{"slicks", medium.slicks, 0, 0.5, "0 to 0.5"}}));
  PELAGIC_CHECK(
      gpu::check("WaterLook::", {{"shallowness", look.shallowness, 0, 1, "0 to 1"},
                                 {"leastOpacity", look.leastOpacity, 0, 1, "0 to 1"},
                                 {"opaqueDepth", look.opaqueDepth, static_cast<double>(0.01f), 1000, "0.01 to 1000 m"},
                                 {"contrast", look.contrast, 1, 4, "1 to 4"}}));
  return {};
}

Result<void> validate(const CompositeTargets& targets, const WaterBuffer& water) {
  const VkExtent2D extent = water.depth.extent;
  const std::string name = "CompositeTargets::";
  PELAGIC_CHECK(gpu::check(
      "WaterBuffer::", {{"planetRadius", water.planetRadius, kLeastPlanetRadius, kMostPlanetRadius, "1e5 to 1e8 m"}}));
  const auto half4 = VK_FORMAT_R16G16B16A16_SFLOAT;
  const auto float4 = VK_FORMAT_R32G32B32A32_SFLOAT;
  PELAGIC_CHECK(checkImage(targets.output, name + "output", extent, {half4, float4}));
  if (targets.color.has_value() != targets.depth.has_value()) {
    return gpu::reject(name + "color and depth must be given both or neither");
  }
  if (targets.color) {
    // Any format with linear values that a shader can sample.
    PELAGIC_CHECK(checkImage(*targets.color, name + "color", extent, {targets.color->format}));
    PELAGIC_CHECK(checkImage(*targets.depth, name + "depth", extent, {VK_FORMAT_D32_SFLOAT}));
  }
  if (targets.normal) PELAGIC_CHECK(checkImage(*targets.normal, name + "normal", extent, {half4, float4}));
  if (targets.slopeVariance) {
    PELAGIC_CHECK(checkImage(*targets.slopeVariance, name + "slopeVariance", extent,
                             {VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R32G32_SFLOAT}));
  }
  if (targets.mergedDepth) {
    PELAGIC_CHECK(checkImage(*targets.mergedDepth, name + "mergedDepth", extent, {VK_FORMAT_R32_SFLOAT}));
  }
  return {};
}

Result<void> validate(const SkyMaps& sky, const WaterBuffer& water) {
  if (sky.light == VK_NULL_HANDLE || sky.lightSize < sizeof(shader::SkyLight)) {
    return gpu::reject("SkyMaps::light has " + std::to_string(sky.light ? sky.lightSize : 0) +
                       " bytes, it must have at least " + std::to_string(sizeof(shader::SkyLight)));
  }
  PELAGIC_CHECK(gpu::check("WaterBuffer::", {{"cellEdge", water.cellEdge, 0, 1e4, "0 to 1e4 px"},
                                             {"planetRadius", water.planetRadius, 1e5, 1e8, "1e5 to 1e8 m"}}));
  if (sky.planetRadius != water.planetRadius) {
    std::ostringstream text;
    text << "SkyMaps::planetRadius is " << sky.planetRadius << ", it must be WaterBuffer's, " << water.planetRadius
         << " m";
    return gpu::reject(text.str());
  }
  return {};
}

Result<void> validate(const ToneMapInfo& info) {
  PELAGIC_CHECK(checkImage(info.input, "ToneMapInfo::input", info.output.extent,
                           {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT}));
  PELAGIC_CHECK(checkImage(info.output, "ToneMapInfo::output", info.output.extent, {VK_FORMAT_R8G8B8A8_UNORM}));
  return {};
}

}  // namespace pelagic
