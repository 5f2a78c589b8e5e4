#include "gpu_test.hpp"

namespace support {

void GpuTest::SetUp() {
  common::GpuDeviceOptions options;
  options.validate = true;
  auto gpu = common::GpuDevice::create(options);
  ASSERT_TRUE(gpu) << gpu.error().message;
  gpu_ = std::make_unique<common::GpuDevice>(std::move(*gpu));
  auto device = pelagic::Device::create(gpu_->info());
  ASSERT_TRUE(device) << device.error().message;
  device_ = std::make_unique<pelagic::Device>(std::move(*device));
}

void GpuTest::TearDown() {
  if (device_) {
    for (const std::uint64_t bytes : device_->memory()) EXPECT_EQ(bytes, 0u) << "a stage still holds memory";
  }
  device_.reset();
  if (gpu_) {
    for (const std::string& message : gpu_->validationMessages()) ADD_FAILURE() << message;
  }
}

}  // namespace support
