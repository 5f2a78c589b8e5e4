/// Base of all GPU tests: a device with validation on; any message that is not on the allow-list fails the test.
#pragma once

#include <gtest/gtest.h>

#include <common/gpu_device.hpp>

namespace support {

class GpuTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  const common::GpuDevice& gpu() const { return *gpu_; }
  pelagic::Device& device() { return *device_; }

 private:
  std::unique_ptr<common::GpuDevice> gpu_;
  std::unique_ptr<pelagic::Device> device_;
};

}  // namespace support
