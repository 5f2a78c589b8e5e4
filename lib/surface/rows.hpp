/// How the rows of the projected grid are spread over the ground.
#pragma once

#include <array>

namespace pelagic::surface {

/// Number of rows per metre along the heading as a function of Z, the distance along it, and its integral.
/// A cell at Z is W(Z) * step wide, W = slope Z + offset: its depth in the picture. Where that would be less than
/// `floor` there is no water in the picture but what the waves bring in: from there back toward the camera cells grow
/// again, W rising by a metre per metre up to 2 floor.
/// Three demands on the rows add up: uniform on screen for a flat sea seen from `height`: height / (step W^2); cells at
/// most kLongestCell times as long as wide, within reason (kFlatter, physics/sheet.glsl), while the waves span a pixel,
/// W < reach; and chords that stay close to the sphere: curvature / sqrt(W).
struct RowDensity {
  double step = 0;       ///< Cell width per W [1], > 0.
  double slope = 0;      ///< dW/dZ in the picture [1], 0 … 1.
  double offset = 0;     ///< W at Z = 0 without the floor [m].
  double floor = 0;      ///< Least W [m], > 0.
  double height = 0;     ///< [m], > 0.
  double reach = 0;      ///< [m], >= 0.
  double curvature = 0;  ///< [1/sqrt(m)], >= 0.

  double width(double z) const noexcept;
  /// Where W bends, in rising order; W is linear between.
  std::array<double, 2> bends() const noexcept;
  /// Rows per metre.
  double density(double z) const noexcept;
  /// Rows between `from` and `to` >= `from`, in closed form.
  double count(double from, double to) const noexcept;
  /// The Z one row before `z`.
  double before(double z) const noexcept;

 private:
  double linearCount(double from, double to) const noexcept;
};

}  // namespace pelagic::surface
