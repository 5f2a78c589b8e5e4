#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <pelagic/ocean.hpp>
#include <span>

#include "support/gpu_test.hpp"

namespace {

using namespace pelagic;

constexpr VkExtent2D kExtent{160, 90};
constexpr ImageState kStorageWritten{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                                     VK_IMAGE_LAYOUT_GENERAL};

/// Reversed infinite projection, Vulkan's y down.
glm::mat4 projection(float fov) {
  const float f = 1 / std::tan(0.5f * fov);
  const float aspect = static_cast<float>(kExtent.width) / static_cast<float>(kExtent.height);
  constexpr float kNear = 0.1f;
  return {{f / aspect, 0, 0, 0}, {0, -f, 0, 0}, {0, 0, 0, -1}, {0, 0, kNear, 0}};
}

/// Looks toward +x, `down` radians below the horizontal.
Camera cameraAt(double height, float down = 0.1f) {
  Camera camera;
  camera.position = {0, height, 0};
  const glm::vec3 forward{std::cos(down), -std::sin(down), 0};
  camera.rotation = glm::mat3(glm::lookAt(glm::vec3(0), forward, glm::vec3(0, 1, 0)));
  camera.projection = projection(0.9f);
  return camera;
}

class OceanTest : public support::GpuTest {
 protected:
  static OceanInfo smallOcean() {
    OceanInfo info;
    info.waves.layout = waveLayout(info.waves.sea, 2, 64).value();
    return info;
  }
  Ocean create(const OceanInfo& info) {
    auto ocean = Ocean::create(device(), info);
    EXPECT_TRUE(ocean) << (ocean ? "" : ocean.error().message);
    return std::move(*ocean);
  }
  common::OwnedImage target(vk::Format format = vk::Format::eR32G32B32A32Sfloat) {
    using Usage = vk::ImageUsageFlagBits;
    return common::createImage(gpu(), format, kExtent, Usage::eStorage | Usage::eTransferSrc, "target");
  }
  OceanView createView(Ocean& ocean, const CompositeTargets& targets) {
    auto view = ocean.createView(targets);
    EXPECT_TRUE(view) << (view ? "" : view.error().message);
    return std::move(*view);
  }
  std::vector<float> read(const common::OwnedImage& image) {
    return common::readFloats(gpu(), *image.image, image.format, image.extent, common::kTransferSource);
  }
  CompositeTargets targetsFor(const common::OwnedImage& image) {
    CompositeTargets targets;
    targets.output = image.host({}, common::kTransferSource);
    return targets;
  }
  void record(Ocean& ocean, OceanView& view, double time, const Camera& camera) {
    gpu().run([&](vk::CommandBuffer commands) {
      ocean.record(commands, time);
      view.record(commands, camera);
    });
  }
  /// One frame of a new ocean.
  std::vector<float> frame(const OceanInfo& info, double time, const Camera& camera) {
    const auto image = target();
    Ocean ocean = create(info);
    OceanView view = createView(ocean, targetsFor(image));
    record(ocean, view, time, camera);
    return read(image);
  }
};

glm::dvec3 meanOfRows(const std::vector<float>& pixels, std::uint32_t first, std::uint32_t last) {
  glm::dvec3 sum(0);
  for (std::uint32_t i = first * kExtent.width; i < last * kExtent.width; ++i) {
    sum += glm::dvec3(pixels[4 * i], pixels[4 * i + 1], pixels[4 * i + 2]);
  }
  return sum / static_cast<double>((last - first) * kExtent.width);
}

TEST_F(OceanTest, EveryPixelIsFiniteAndTheSeaIsDarkerThanTheSky) {
  OceanInfo info = smallOcean();
  info.sky.sunAzimuth = 3.14;  // behind the camera: no glitter
  const auto pixels = frame(info, 3, cameraAt(4));
  for (const float value : pixels) {
    ASSERT_TRUE(std::isfinite(value));
    ASSERT_GE(value, 0);
  }
  const glm::dvec3 sky = meanOfRows(pixels, 0, 20);
  const glm::dvec3 sea = meanOfRows(pixels, 60, 90);
  EXPECT_GT(sky.z, sky.x);  // a clear sky is blue
  EXPECT_LT(sea.y, 0.6 * sky.y);
  EXPECT_GT(sea.y, 0.01 * sky.y);
}

TEST_F(OceanTest, LightsComeAndGo) {
  OceanInfo info = smallOcean();
  info.sky.sunElevation = -0.2;
  const auto image = target();
  Ocean ocean = create(info);
  OceanView view = createView(ocean, targetsFor(image));
  const Camera camera = cameraAt(4);
  record(ocean, view, 3, camera);
  const auto dark = read(image);
  HostLight lamp;
  lamp.position = {30, 5, 0};
  ASSERT_TRUE(ocean.setLights({{lamp}}));
  record(ocean, view, 3, camera);
  const auto bright = read(image);
  // It shines toward the eye from ahead, and on no part of the sky.
  EXPECT_GT(meanOfRows(bright, 60, 90).y, 1.2 * meanOfRows(dark, 60, 90).y);
  EXPECT_EQ(meanOfRows(bright, 0, 20), meanOfRows(dark, 0, 20));
  info.lights = {lamp};
  EXPECT_EQ(frame(info, 3, camera), bright);
  ASSERT_TRUE(ocean.setLights({}));
  record(ocean, view, 3, camera);
  EXPECT_EQ(read(image), dark);
}

TEST_F(OceanTest, AnyTimeInAnyOrderGivesTheSameBits) {
  const auto image = target();
  Ocean ocean = create(smallOcean());
  OceanView view = createView(ocean, targetsFor(image));
  const Camera camera = cameraAt(3);
  for (const double time : {100.0, 2.25, 7.1}) record(ocean, view, time, camera);
  EXPECT_EQ(read(image), frame(smallOcean(), 7.1, camera));
}

TEST_F(OceanTest, TwoRecordedFramesGiveTheSameBitsAsFramesOneByOne) {
  const auto image = target();
  Ocean ocean = create(smallOcean());
  OceanView view = createView(ocean, targetsFor(image));
  const Camera camera = cameraAt(3);
  const auto pool = gpu().device().createCommandPoolUnique({{}, gpu().queueFamily()});
  const auto buffers = gpu().device().allocateCommandBuffersUnique({*pool, vk::CommandBufferLevel::ePrimary, 2});
  SeaState stronger;
  stronger.windSpeed = 9;
  for (std::size_t i = 0; i < 2; ++i) {
    // The second frame changes the sea while the first is not even submitted.
    if (i == 1) {
      ASSERT_TRUE(ocean.setSea(stronger));
    }
    buffers[i]->begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
    ocean.record(*buffers[i], 1 + static_cast<double>(i));
    view.record(*buffers[i], camera);
    buffers[i]->end();
  }
  for (const auto& buffer : buffers) gpu().queue().submit(vk::SubmitInfo({}, {}, *buffer));
  gpu().queue().waitIdle();
  const auto together = read(image);

  Ocean other = create(smallOcean());
  OceanView otherView = createView(other, targetsFor(image));
  record(other, otherView, 1, camera);
  ASSERT_TRUE(other.setSea(stronger));
  record(other, otherView, 2, camera);
  EXPECT_EQ(read(image), together);
}

/// What a view leaves: the picture, and all that it knows of the water.
struct Left {
  std::vector<float> picture, body, depth, motion;
  bool operator==(const Left&) const = default;
};

/// A view: its size and camera, and the image that it draws to.
struct Shot {
  VkExtent2D extent;
  Camera camera;
  std::optional<common::OwnedImage> image;
};

class OceanViewsTest : public OceanTest {
 protected:
  /// Two frames of a new ocean, seen by all of these views, recorded before the first is submitted.
  std::vector<Left> draw(const OceanInfo& info, std::span<Shot* const> shots) {
    Ocean ocean = create(info);
    std::vector<OceanView> views;
    for (Shot* shot : shots) {
      using Usage = vk::ImageUsageFlagBits;
      shot->image = common::createImage(gpu(), vk::Format::eR32G32B32A32Sfloat, shot->extent,
                                        Usage::eStorage | Usage::eTransferSrc, "view");
      views.push_back(createView(ocean, targetsFor(*shot->image)));
    }
    const auto pool = gpu().device().createCommandPoolUnique({{}, gpu().queueFamily()});
    const auto frames = gpu().device().allocateCommandBuffersUnique({*pool, vk::CommandBufferLevel::ePrimary, 2});
    double time = 2;
    for (const auto& commands : frames) {
      commands->begin(vk::CommandBufferBeginInfo(vk::CommandBufferUsageFlagBits::eOneTimeSubmit));
      ocean.record(*commands, time);
      for (std::size_t i = 0; i < views.size(); ++i) {
        Camera camera = shots[i]->camera;
        camera.position.z += time;
        views[i].record(*commands, camera);
      }
      commands->end();
      time += 0.5;
    }
    for (const auto& commands : frames) gpu().queue().submit(vk::SubmitInfo({}, {}, *commands));
    gpu().queue().waitIdle();
    std::vector<Left> left;
    for (std::size_t i = 0; i < views.size(); ++i) left.push_back(leftBy(views[i], *shots[i]->image));
    return left;
  }

 private:
  Left leftBy(const OceanView& view, const common::OwnedImage& image) {
    const WaterBuffer water = view.waterBuffer();
    Left left{read(image), common::readFloats(gpu(), water.body), common::readFloats(gpu(), water.depth),
              common::readFloats(gpu(), water.motion)};
    for (std::size_t p = 0; p < left.motion.size(); ++p) {
      if (left.body[p / 2] == 0) left.motion[p] = 0;  // undefined without water
    }
    return left;
  }
};

TEST_F(OceanViewsTest, ViewsOfOneFrameAreAsDrawnAlone) {
  OceanInfo info = smallOcean();
  info.surface.motionVectors = true;
  info.sky.clouds.cover = 0.3;
  std::vector<Shot> shots;
  shots.push_back({kExtent, cameraAt(3), {}});
  shots.push_back({{97, 61}, cameraAt(0.2, -0.05f), {}});  // among the crests
  shots.push_back({{64, 80}, cameraAt(20e3, 0.4f), {}});
  shots.push_back({kExtent, cameraAt(50, 1.5f), {}});
  shots.back().camera.projection[2] = glm::vec4(0.4f, -0.3f, 0, -1);
  shots[1].camera.rotation = glm::mat3(glm::rotate(glm::mat4(1), 0.7f, glm::vec3(0, 0, 1))) * shots[1].camera.rotation;
  const std::vector<Left> together = draw(info, std::array{&shots[0], &shots[1], &shots[2], &shots[3]});
  for (std::size_t i = 0; i < shots.size(); ++i) {
    EXPECT_EQ(draw(info, std::array{&shots[i]}).front(), together[i]) << "view " << i;
    EXPECT_NE(std::count(together[i].body.begin(), together[i].body.end(), 1.0f), 0) << "view " << i;
  }
}

TEST_F(OceanTest, SettersTakeEffectAndRefuseWhatIsOutOfRange) {
  const auto image = target();
  Ocean ocean = create(smallOcean());
  OceanView view = createView(ocean, targetsFor(image));
  record(ocean, view, 2, cameraAt(3));
  const auto before = read(image);

  SeaState bad;
  bad.windSpeed = 1000;
  EXPECT_EQ(ocean.setSea(bad).error().message, "SeaState::windSpeed is 1000, it must lie in 0.1 … 60 m/s");
  WaterMedium opaque;
  opaque.absorption.y = std::nanf("");
  EXPECT_FALSE(ocean.setMedium(opaque));
  SkyState sky;
  sky.overcast = 2;
  EXPECT_FALSE(ocean.setSky(sky));
  record(ocean, view, 2, cameraAt(3));
  EXPECT_EQ(read(image), before);

  sky.overcast = 1;
  ASSERT_TRUE(ocean.setSky(sky));
  record(ocean, view, 2, cameraAt(3));
  EXPECT_NE(read(image), before);
}

TEST_F(OceanTest, HostObjectsHideAndAreHidden) {
  using Usage = vk::ImageUsageFlagBits;
  const auto image = target();
  const auto color = common::createImage(gpu(), vk::Format::eR32G32B32A32Sfloat, kExtent,
                                         Usage::eSampled | Usage::eTransferDst, "host colour");
  const auto depth =
      common::createImage(gpu(), vk::Format::eD32Sfloat, kExtent, Usage::eSampled | Usage::eTransferDst, "host depth");
  const auto merged = target(vk::Format::eR32Sfloat);
  const ImageState cleared{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
  const ImageState sampled{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  CompositeTargets targets = targetsFor(image);
  targets.color = color.host(cleared, sampled);
  targets.depth = depth.host(cleared, sampled);
  targets.mergedDepth = merged.host({}, common::kTransferSource);
  Ocean ocean = create(smallOcean());
  targets.airBeforeHost = false;
  OceanView bare = createView(ocean, targets);
  targets.airBeforeHost = true;
  OceanView behindAir = createView(ocean, targets);
  const glm::vec3 red{3, 0.25f, 0.125f};
  // A wall across the view at `wall` metres: reversed infinite depth is near / distance.
  const auto render = [&](float wall, OceanView& view) {
    gpu().run([&](vk::CommandBuffer commands) {
      const auto barrier = [&](const common::OwnedImage& target, vk::ImageAspectFlags aspect) {
        const vk::ImageMemoryBarrier2 toClear({}, {}, vk::PipelineStageFlagBits2::eAllTransfer,
                                              vk::AccessFlagBits2::eTransferWrite, vk::ImageLayout::eUndefined,
                                              vk::ImageLayout::eTransferDstOptimal, VK_QUEUE_FAMILY_IGNORED,
                                              VK_QUEUE_FAMILY_IGNORED, *target.image, {aspect, 0, 1, 0, 1});
        commands.pipelineBarrier2({{}, {}, {}, toClear});
      };
      barrier(color, vk::ImageAspectFlagBits::eColor);
      barrier(depth, vk::ImageAspectFlagBits::eDepth);
      commands.clearColorImage(*color.image, vk::ImageLayout::eTransferDstOptimal,
                               vk::ClearColorValue(red.x, red.y, red.z, 1.0f),
                               vk::ImageSubresourceRange(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1));
      commands.clearDepthStencilImage(*depth.image, vk::ImageLayout::eTransferDstOptimal,
                                      vk::ClearDepthStencilValue(0.1f / wall, 0),
                                      vk::ImageSubresourceRange(vk::ImageAspectFlagBits::eDepth, 0, 1, 0, 1));
      ocean.record(commands, 2);
      view.record(commands, cameraAt(4));
    });
    return read(image);
  };
  const auto isRed = [&](const std::vector<float>& pixels, std::uint32_t i) {
    return pixels[4 * i] == red.x && pixels[4 * i + 1] == red.y && pixels[4 * i + 2] == red.z;
  };

  const auto pixels = render(25, bare);
  const auto depths = read(merged);
  std::uint32_t wallPixels = 0;
  for (std::uint32_t i = 0; i < kExtent.width * kExtent.height; ++i) {
    // The nearer of both: 0.1/25 is the wall, anything greater is water in front of it.
    ASSERT_GE(depths[i], 0.1f / 25);
    ASSERT_EQ(isRed(pixels, i), depths[i] == 0.1f / 25) << "pixel " << i;
    wallPixels += isRed(pixels, i) ? 1 : 0;
  }
  // The upper half is wall, the bottom row is water 4 m below the eye.
  EXPECT_GT(wallPixels, kExtent.width * kExtent.height / 3);
  EXPECT_FALSE(isRed(pixels, (kExtent.height - 1) * kExtent.width + 80));
  // A quarter of a percent of air lies before the wall.
  const auto aired = render(25, behindAir);
  for (std::uint32_t i = 0; i < kExtent.width * kExtent.height; ++i) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(aired[4 * i + c], pixels[4 * i + c], isRed(pixels, i) ? 0.005f * red[static_cast<int>(c)] : 0.0f)
          << i;
    }
    ASSERT_EQ(isRed(aired, i), false);
  }
  // Without an object (depth is the far value) the host's colour appears nowhere.
  const auto open = render(std::numeric_limits<float>::infinity(), behindAir);
  for (std::uint32_t i = 0; i < kExtent.width * kExtent.height; ++i) ASSERT_FALSE(isRed(open, i));
}

TEST_F(OceanTest, EveryStageAccountsForItsMemory) {
  const auto image = target();
  {
    Ocean ocean = create(smallOcean());
    OceanView view = createView(ocean, targetsFor(image));
    for (const std::uint64_t bytes : device().memory()) EXPECT_GT(bytes, 0u);
  }
  for (const std::uint64_t bytes : device().memory()) EXPECT_EQ(bytes, 0u);
}

}  // namespace
