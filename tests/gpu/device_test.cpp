#include <pelagic/timings.hpp>

#include "support/gpu_test.hpp"

namespace {

class DeviceTest : public support::GpuTest {};

TEST_F(DeviceTest, NullHandleIsNamed) {
  pelagic::DeviceInfo info = gpu().info();
  info.device = VK_NULL_HANDLE;
  const auto device = pelagic::Device::create(info);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().message, "DeviceInfo::device is null");
}

TEST_F(DeviceTest, QueueFamilyOutOfRangeIsNamed) {
  pelagic::DeviceInfo info = gpu().info();
  info.queueFamily = 99;
  const auto device = pelagic::Device::create(info);
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().code, pelagic::ErrorCode::invalidArgument);
  EXPECT_NE(device.error().message.find("queueFamily is 99"), std::string::npos);
}

TEST_F(DeviceTest, TimingsMeasureWhatLiesBetween) {
  auto timings = pelagic::Timings::create(device());
  ASSERT_TRUE(timings);
  gpu().run([&](vk::CommandBuffer commands) {
    timings->reset(commands);
    timings->begin(commands, "nothing");
    timings->end(commands);
  });
  const auto passes = timings->read();
  ASSERT_TRUE(passes);
  ASSERT_EQ(passes->size(), 1u);
  EXPECT_STREQ((*passes)[0].name, "nothing");
  EXPECT_GE((*passes)[0].milliseconds, 0);
}

}  // namespace
