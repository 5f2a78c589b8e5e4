/// The wave stage: spectrum, FFT cascades, foam history and filtered maps. Usable without the other stages.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <pelagic/device.hpp>
#include <pelagic/gain_map.hpp>
#include <pelagic/image.hpp>
#include <pelagic/sea_state.hpp>
#include <pelagic/spectrum.hpp>
#include <pelagic/timings.hpp>

namespace pelagic {

inline constexpr std::uint32_t kMaxCascades = 8;

/// Share of a cascade's slope variance that is lost between the texels of each mip, the finest first [1]. In mips
/// coarser than these, whose texels are longer than any wave (waveLayout()), nothing is left to be lost.
using InterpolationLoss = std::array<double, 8>;

/// Share of it that is seen there, sampled linearly; coarser mips show nothing.
using ResolvedShare = std::array<double, 8>;

/// One FFT patch: an axis-aligned square of the sea, repeated.
struct Cascade {
  double length = 0;  ///< L [m]; sample (i,j) lies at x = j L/N, z = i L/N.
  double kMin = 0;    ///< The cascade holds the modes with kMin <= |k| < kMax [rad/m]; no other cascade does.
  double kMax = 0;
};

/// How the wave-number plane is cut up. Fixed when a simulation is created.
struct WaveLayout {
  std::uint32_t size = 256;  ///< N: samples along each side of every patch, a power of two, 64 … 1024.
  std::uint32_t count = 4;   ///< Cascades, 1 … kMaxCascades, longest first.
  std::array<Cascade, kMaxCascades> cascades{};
};

/// The layout for the strongest sea a simulation is to hold: longest patch kPatchWavelengths of its longest train,
/// inner edges at mode >= 16, outer edges at 0.7 of the Nyquist mode, ratios of lengths irrational. The longest patch
/// holds nearly all of the elevation. Where patches are laid side by side without WavesInfo::warp, the sea repeats at
/// its length: `span`, 0 … 1e5 [m], makes it that long at least. What it then cannot hold repeats in the next patch:
/// the default sea over 2 km keeps 0.76 of its variance in the longest patch with 256 samples, 0.94 with 512, 0.98
/// with 1024.
Result<WaveLayout> waveLayout(const SeaState& strongest, std::uint32_t count = 4, std::uint32_t size = 256,
                              double span = 0);

enum class MapPrecision {
  half,    ///< 16-bit float maps: for pictures.
  single,  ///< 32-bit float maps: for data; twice the memory and store time.
};

struct WavesInfo {
  SeaState sea;
  WaveLayout layout;
  /// Loop period T [s], 1 … 2^22. Frequencies are multiples of 1/T: the sea repeats exactly after T.
  double loopPeriod = 4194304;
  MapPrecision precision = MapPrecision::half;
  /// Calls of record() whose command buffers may be unfinished at a time, 1 … 4.
  std::uint32_t framesInFlight = 2;
  /// How far the patches are warped, so that nothing is seen to repeat: the standard deviation of each component of
  /// the warp's gradient, 0 … 0.1 [1]. Wavelengths and directions vary by as much from place to place, over 3 to 12
  /// lengths of the longest patch, at unchanged frequencies: what a buoy measures stays exact, slope variances grow by
  /// the factor 1 + 2 warp^2. About the origin of the world waves are as without. The default leaves a wind sea
  /// a correlation of less than 0.05 at all lags from 5 peak waves to 2 km; 0: the patches are laid side by side.
  double warp = 0.05;
  /// Empty: the sea is the same everywhere, and shaders do not look. Width and height are fixed from here on.
  GainMap gain;
};

/// The maps of the sea at one time: 2-D arrays, layer = cascade, row = z, column = x, repeating; texel (i,j)'s centre,
/// at texture coordinate ((j+0.5)/N, (i+0.5)/N), is the point x = j L/N, z = i L/N of the patch. All have a full mip
/// chain of box filters. Sum over cascades. Derivatives are taken over the patch. A point p = (x, z) of the undisplaced
/// plane finds its water at q = p + w(p), waveWarp() in shader/wave_lookup.glsl: P = (x + Dx(q), h(q), z + Dz(q)),
/// whose derivatives over p are those over q times 1 + dw/dp, waveWarpSlopes().
struct WaveMaps {
  MapView displacement;  ///< RGBA: Dx, h, Dz [m], Jacobian of this cascade alone (1 + dDx/dx)(1 + dDz/dz) - (dDz/dx)^2.
  MapView gradient;      ///< RGBA: dh/dx, dh/dz, dDx/dx, dDz/dz [1].
  MapView moments;       ///< RGBA: variance of dh/dx, of dh/dz, their covariance, within the texel [1]; dDz/dx [1].
  MapView foam;          ///< R: foam of this cascade, 0 … 1 (1: breaking now; falls linearly over kFoamLifetime).
  /// As `displacement`, of the record call before the last one; for motion vectors.
  MapView previousDisplacement;
  /// The two images that `displacement` and `previousDisplacement` are taken from, in an order that never changes: what
  /// a view binds when it is created. `previousDisplacement` may be equal to `displacement` until two times are
  /// recorded.
  std::array<MapView, 2> displacementPair;

  /// R: gain of this cascade's waves, r32f; null without WavesInfo::gain. The other maps are without it: multiply.
  MapView gain;
  glm::dvec2 gainOrigin{0};  ///< As GainMap::origin [m] and
  double gainSpacing = 1;    ///< GainMap::spacing [m].
  double foamDecline = 0;    ///< w of foamOfGain() in shader/wave_gain.glsl [1].

  WaveLayout layout;
  double warp = 0;           ///< As WavesInfo::warp.
  double windDirection = 0;  ///< [rad], as in SeaState.
  double windSpeed = 0;      ///< [m/s], as in SeaState.
  /// Slope variance of the real sea that no cascade resolves, along and across the wind [1]: Cox & Munk's total less
  /// what the grid holds, at least the spectrum's own tail.
  SlopeVariance unresolved;
  /// Expected slope variance of each cascade along x, along z and their covariance [1].
  std::array<glm::dvec3, kMaxCascades> slopeCovariance{};
  /// By how much of it a linear filter smooths the gradients of each mip, in the mean over places between the texels.
  /// `moments` holds what is lost within texels alone: add this times slopeCovariance where maps are sampled linearly.
  std::array<InterpolationLoss, kMaxCascades> interpolationLoss{};
  /// What of it the gradients of each mip show.
  std::array<ResolvedShare, kMaxCascades> resolvedShare{};
  /// Standard deviation of the elevation [m], Hs/4 on the grid, where the gain is largest, or more where trochoids may
  /// meet; no crest is expected above 6 of them.
  double elevationDeviation = 0;
  /// Standard deviation of the length of the horizontal displacement (Dx, Dz) [m]: choppiness * elevationDeviation in
  /// deep water, more in shallow.
  double horizontalDeviation = 0;
  double choppiness = 1;
};

/// How long foam lives after a crest broke [s].
inline constexpr double kFoamLifetime = 8;

/// How many peak wavelengths of the longest train the longest patch must hold at least.
inline constexpr double kLeastWavelengths = 8;
/// How many waveLayout() puts there: the more, the less warp is needed to hide that the patch repeats, but the more of
/// the shortest waves are left to the unresolved variance.
inline constexpr double kPatchWavelengths = 11.5;

/// What the sea asked for has become on the grid.
struct SeaReport {
  double targetHeight = 0;  ///< Hs of the spectrum [m].
  double gridHeight = 0;    ///< Expected Hs of the grid's modes [m].
  double peakPeriod = 0;    ///< Tp of the spectrum [s].
  /// Tp of the grid's modes [s]: peakPeriod moved by as much as the modes' peak frequency, weighted as Young (1995)
  /// does by the fourth power of the spectrum, is off the spectrum's. Within 0.2 % where the layout fits the sea.
  double gridPeakPeriod = 0;
  /// Peak wavelengths of the longest train that fit into the longest patch [1]. Below kLeastWavelengths the layout is
  /// too short for the sea: its longest waves are overstated, by 5 % of m0 at 3, by half at 1.
  double wavelengthsInPatch = 0;
  SlopeVariance target;  ///< Cox & Munk [1].
  SlopeVariance grid;    ///< Expected of the grid's modes [1].
  SlopeVariance unresolved;
  double whitecaps = 0;  ///< Target whitecap fraction [1].
  /// Largest relative change of a mode's frequency by the loop period, pi / (T w) at most [1].
  double frequencyError = 0;
  /// What the steepness of every trochoid was multiplied by, so that the crests of trochoids alone do not loop [1]; 1:
  /// all are as asked for.
  double steepnessScale = 1;
};

/// Owns the spectrum, the FFT pipelines and the maps. Move-only; one thread at a time.
class Waves {
 public:
  static Result<Waves> create(Device& device, const WavesInfo& info);
  Waves(Waves&&) noexcept;
  Waves& operator=(Waves&&) noexcept;
  ~Waves();

  /// Replaces the sea; lengths, random numbers and phases stay, modes are re-weighted. Takes effect with the next
  /// record(), over the time of `transition`. A sea that is still changing when the transition starts goes on from the
  /// heights it has then: speeds may jump a little, and where depth or choppiness differ, or a leaning sea's
  /// wind turns about, the displacements by centimetres to decimetres. CPU work only. On error nothing changes.
  Result<void> setSea(const SeaState& sea, const SeaTransition& transition = {});
  /// Replaces the map of gains by one of the same width and height, with the next record(). CPU work only. On error
  /// nothing changes.
  Result<void> setGain(const GainMap& map);
  /// Records the whole stage for `time` [s] (any finite value, any order); not within rendering. Before: the maps rest
  /// in kShaderRead; after: again, with the new sea visible to every later shader read on the queue.
  void record(VkCommandBuffer commands, double time, Timings* timings = nullptr) noexcept;

  /// The maps as of the last record(); valid until the next one. Views stay the same two sets in turn:
  /// `displacement` and `previousDisplacement` change places at each record().
  WaveMaps maps() const noexcept;
  SeaReport report() const noexcept;
  /// The sea's trochoids as they are on the grid, those given one by one first, then those picked.
  std::vector<Trochoid> trochoids() const;
  /// Expected E|h(k)|^2 [m^2] of every mode of a cascade before any random number, N x N in FFT order, row = z.
  std::vector<double> modeVariance(std::uint32_t cascade) const;

 private:
  friend class PointQuery;
  struct Impl;
  explicit Waves(std::unique_ptr<Impl> impl) noexcept;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelagic
