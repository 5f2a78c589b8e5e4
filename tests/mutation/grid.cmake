# The discretisation and what is computed from it; see WrongFormula.cmake.

set(source layout.cpp)
wrong_formula(patch_length RIGHT "kPatchWavelengths * longestPeakWavelength(strongest)"
              WRONG "longestPeakWavelength(strongest)" CAUGHT_BY Layout.PartitionsTheWaveNumbers)
wrong_formula(nyquist RIGHT "0.7 * 0.5 * size" WRONG "0.7 * size" CAUGHT_BY Layout.PartitionsTheWaveNumbers)
wrong_formula(outer_edge RIGHT "outerMode * 2 * std::numbers::pi / length" WRONG "outerMode / length"
              CAUGHT_BY Layout.PartitionsTheWaveNumbers)
wrong_formula(overlap RIGHT "inner = outer" WRONG "inner = 0.5 * outer" CAUGHT_BY Layout.PartitionsTheWaveNumbers)
wrong_formula(inner_mode RIGHT "outerMode / 16" WRONG "outerMode / 8" CAUGHT_BY Layout.PartitionsTheWaveNumbers)

set(source modes.cpp)
wrong_formula(sqrt_2 RIGHT "-std::log(u1)" WRONG "-2 * std::log(u1)"
              CAUGHT_BY Modes.AmplitudesAreGaussianWithTheExpectedVariance)
wrong_formula(dk RIGHT "(spectra.wind + spectra.swell) * dk * dk" WRONG "(spectra.wind + spectra.swell) * dk"
              CAUGHT_BY Modes.CarryTheSpectrumsEnergy)
wrong_formula(transposed RIGHT "waveNumberSpectra(sea, kx, kz)" WRONG "waveNumberSpectra(sea, kz, kx)"
              CAUGHT_BY Modes.CarryTheSpectrumsEnergy)
wrong_formula(half RIGHT "std::sqrt(0.5 * energy[index])" WRONG "std::sqrt(energy[index])"
              CAUGHT_BY Modes.AmplitudesAreGaussianWithTheExpectedVariance)
wrong_formula(half_backward RIGHT "std::sqrt(0.5 * energy[opposite])" WRONG "std::sqrt(energy[opposite])"
              CAUGHT_BY Modes.AreHermitianSoThatTheSeaIsReal)
wrong_formula(energy_of_the_wrong_mode RIGHT "std::sqrt(0.5 * energy[opposite])" WRONG "std::sqrt(0.5 * energy[index])"
              CAUGHT_BY Modes.AreHermitianSoThatTheSeaIsReal)
wrong_formula(conj RIGHT "std::conj(randomAmplitude(sea.seed, cascade, -mx, -mz))"
              WRONG "randomAmplitude(sea.seed, cascade, -mx, -mz)" CAUGHT_BY Modes.AreHermitianSoThatTheSeaIsReal)
wrong_formula(conj_of_the_wrong_mode RIGHT "std::conj(randomAmplitude(sea.seed, cascade, -mx, -mz))"
              WRONG "std::conj(randomAmplitude(sea.seed, cascade, mx, mz))"
              CAUGHT_BY Modes.AreHermitianSoThatTheSeaIsReal)
wrong_formula(variance RIGHT "0.5 * (energy[index] + energy[opposite])" WRONG "energy[index] + energy[opposite]"
              CAUGHT_BY Modes.CarryTheSpectrumsEnergy)
wrong_formula(overlap RIGHT "k >= patch.kMin" WRONG "k >= 0.5 * patch.kMin" CAUGHT_BY Modes.SumToTheSpectrumsIntegrals)
wrong_formula(cycles RIGHT "angularFrequency(k, sea.depth) * loopPeriod / kTwoPi"
              WRONG "angularFrequency(k, sea.depth) * loopPeriod" CAUGHT_BY Modes.TurnAWholeNumberOfTimesPerLoop)
wrong_formula(chop_1_over_k RIGHT "sea.choppiness / (std::tanh(k * sea.depth) * k)"
              WRONG "sea.choppiness / std::tanh(k * sea.depth)"
              CAUGHT_BY Modes.MoveWaterSidewaysAsFarAsUpwardInDeepWaterAndFartherInShallow)
wrong_formula(chop_coth RIGHT "sea.choppiness / (std::tanh(k * sea.depth) * k)" WRONG "sea.choppiness / k"
              CAUGHT_BY Modes.MoveWaterSidewaysAsFarAsUpwardInDeepWaterAndFartherInShallow)
wrong_formula(chop_tanh RIGHT "sea.choppiness / (std::tanh(k * sea.depth) * k)"
              WRONG "sea.choppiness * std::tanh(k * sea.depth) / k"
              CAUGHT_BY Modes.MoveWaterSidewaysAsFarAsUpwardInDeepWaterAndFartherInShallow)
wrong_formula(lean_backward RIGHT "-std::sin(angle)" WRONG "std::sin(angle)"
              CAUGHT_BY Lean.SkewsSlopesAsCoxAndMunkMeasured)
wrong_formula(lean_direction RIGHT "std::atan2(mz, mx) - sea.windDirection" WRONG "std::atan2(mz, mx)"
              CAUGHT_BY Lean.IsOfTheWindSeaAndWithTheWind)
wrong_formula(lean_of_swell RIGHT "lean * windShare" WRONG "lean" CAUGHT_BY Lean.IsOfTheWindSeaAndWithTheWind)
wrong_formula(loop_fraction RIGHT "rest / loopPeriod" WRONG "rest / (2 * loopPeriod)"
              CAUGHT_BY LoopFraction.IsExactForLongTimes)
wrong_formula(loop_bits RIGHT "std::ldexp(fraction, 64)" WRONG "std::ldexp(fraction, 63)"
              CAUGHT_BY LoopFraction.IsExactForLongTimes)
wrong_formula(before_zero RIGHT "rest += loopPeriod" WRONG "rest = -rest" CAUGHT_BY LoopFraction.IsExactForLongTimes)
wrong_formula(moments_lean RIGHT "glm::length(glm::dvec2(modes.constants[mode].chop))"
              WRONG "static_cast<double>(modes.constants[mode].chop.x)"
              CAUGHT_BY Modes.MoveWaterSidewaysAsFarAsUpwardInDeepWaterAndFartherInShallow)
wrong_formula(moments_chop RIGHT "variance * chop * chop * (kx * kx + kz * kz)"
              WRONG "variance * chop * (kx * kx + kz * kz)"
              CAUGHT_BY Modes.MoveWaterSidewaysAsFarAsUpwardInDeepWaterAndFartherInShallow)
wrong_formula(slope_axes RIGHT "glm::dvec3(kx * kx, kz * kz, kx * kz)" WRONG "glm::dvec3(kz * kz, kx * kx, kx * kz)"
              CAUGHT_BY GridSea.ReportsSlopesAlongTheWind)
wrong_formula(slope_covariance RIGHT "glm::dvec3(kx * kx, kz * kz, kx * kz)"
              WRONG "glm::dvec3(kx * kx, kz * kz, -kx * kz)" CAUGHT_BY GridSea.ReportsSlopesAlongTheWind)

set(source lean.cpp)
wrong_formula(cube RIGHT "6 * kAlong" WRONG "3 * kAlong" CAUGHT_BY Lean.SkewsSlopesAsCoxAndMunkMeasured)
wrong_formula(deviation RIGHT "std::sqrt(coxMunkSlopes(sea.windSpeed).upwind)" WRONG "coxMunkSlopes(sea.windSpeed).upwind"
              CAUGHT_BY Lean.SkewsSlopesAsCoxAndMunkMeasured)

set(source grid_sea.cpp)
wrong_formula(along_wind RIGHT "covariance.x * c * c + covariance.y * s * s + 2 * covariance.z * c * s"
              WRONG "covariance.x * c * c + covariance.y * s * s + covariance.z * c * s"
              CAUGHT_BY GridSea.ReportsSlopesAlongTheWind)
wrong_formula(along_wind_sign RIGHT "covariance.x * c * c + covariance.y * s * s + 2 * covariance.z * c * s"
              WRONG "covariance.x * c * c + covariance.y * s * s - 2 * covariance.z * c * s"
              CAUGHT_BY GridSea.ReportsSlopesAlongTheWind)
wrong_formula(significant_height RIGHT "4 * std::sqrt(grid.moments.elevation)" WRONG "2 * std::sqrt(grid.moments.elevation)"
              CAUGHT_BY GridSea.SaysWhenThePatchesAreTooShort)
wrong_formula(frequency_error RIGHT "kTwoPi * cycles / (loopPeriod * w) - 1"
              WRONG "kTwoPi * cycles / (loopPeriod * w * w) - 1" CAUGHT_BY GridSea.SaysHowFarALoopBendsFrequencies)
wrong_formula(patch RIGHT "layout.cascades[0].length / longestPeakWavelength(sea)"
              WRONG "longestPeakWavelength(sea) / layout.cascades[0].length"
              CAUGHT_BY GridSea.SaysWhenThePatchesAreTooShort)
wrong_formula(foaming_band RIGHT "std::sqrt(cascade.kMin * cascade.kMax)" WRONG "std::sqrt(cascade.kMin * cascade.kMin)"
              CAUGHT_BY GridSea.KeepsFoamOfWavesLongerThanFourMetres)
wrong_formula(foaming_length RIGHT "kTwoPi / kShortestFoamingWave" WRONG "1 / kShortestFoamingWave"
              CAUGHT_BY GridSea.KeepsFoamOfWavesLongerThanFourMetres)
wrong_formula(unresolved RIGHT "report.target.upwind - report.grid.upwind"
              WRONG "report.target.upwind + report.grid.upwind" CAUGHT_BY GridSea.ReportsSlopesAlongTheWind)

set(source closure.cpp)
wrong_formula(wave_number RIGHT "kStep * k * k * k" WRONG "kStep * k * k"
              CAUGHT_BY SlopeBudget.WavesEndWhereTheLawsSlopesReachTheMeasured)
wrong_formula(only_upwind RIGHT "measured.upwind + measured.crosswind" WRONG "measured.upwind"
              CAUGHT_BY SlopeBudget.WavesEndWhereTheLawsSlopesReachTheMeasured)
wrong_formula(within_the_peak RIGHT "10 * peak" WRONG "peak"
              CAUGHT_BY SlopeBudget.HoldsTheWavesThatCarryTheHeightInTheFaintestWind)

set(source interpolation.cpp)
wrong_formula(half_angle RIGHT "std::sin(0.5 * samples * angle)" WRONG "std::sin(samples * angle)"
              CAUGHT_BY SlopeBudget.InterpolationTakesWhatIsLostBetweenTexels)
wrong_formula(mean_power RIGHT "mean * mean" WRONG "mean"
              CAUGHT_BY SlopeBudget.InterpolationTakesWhatIsLostBetweenTexels)
wrong_formula(between RIGHT "(2 + std::cos(samples * angle)) / 3" WRONG "(1 + std::cos(samples * angle)) / 2"
              CAUGHT_BY SlopeBudget.InterpolationTakesWhatIsLostBetweenTexels)
wrong_formula(elevation RIGHT "std::pow(modeOf(column, size), 2) + std::pow(modeOf(row, size), 2)" WRONG "1"
              CAUGHT_BY SlopeBudget.InterpolationTakesWhatIsLostBetweenTexels)
wrong_formula(resolved RIGHT "x.mean * z.mean * x.between * z.between" WRONG "x.mean * z.mean * x.between"
              CAUGHT_BY SlopeBudget.InterpolationTakesWhatIsLostBetweenTexels)

set(source fft.cpp)
wrong_formula(sign RIGHT "2 * std::numbers::pi * i / size" WRONG "-2 * std::numbers::pi * i / size"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)

set(source cpu_lattice.cpp)
wrong_formula(sign_of_time RIGHT "kTwoPi * 0x1p-64 * static_cast<double>(turn)"
              WRONG "-kTwoPi * 0x1p-64 * static_cast<double>(turn)"
              CAUGHT_BY Query.WavesRunWithTheWindAndWaterCirclesForwardOnCrests)
wrong_formula(backward_sign RIGHT "a.w * e.x + a.z * e.y" WRONG "a.w * e.x - a.z * e.y"
              CAUGHT_BY Query.LatticeIsTheSumOfTheModesAtAnyTime)
wrong_formula(lean RIGHT "times(wave.chop, part)" WRONG "wave.chop.x * part"
              CAUGHT_BY Query.LatticeIsTheSumOfTheModesAtAnyTime)
wrong_formula(frequency RIGHT "kTwoPi * constants.cycles / loopPeriod_" WRONG "constants.cycles / loopPeriod_"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(transposed RIGHT "static_cast<float>(k.x)" WRONG "static_cast<float>(k.y)"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(displacement_sign RIGHT "timesI(of.chop) * m.kx" WRONG "timesI(of.chop) * -m.kx"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(displacement_axis RIGHT "timesI(of.chop) * m.kz" WRONG "timesI(of.chop) * m.kx"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(slope RIGHT "timesI(of.h) * m.kx" WRONG "timesI(of.h) * -m.kx" CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(stretch RIGHT "of.chop * (-m.kx * m.kx)" WRONG "of.chop * (m.kx * m.kx)"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(shear RIGHT "of.chop * (-m.kz * m.kx)" WRONG "of.chop * (-m.kz * m.kz)"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(velocity RIGHT "backward - forward" WRONG "forward - backward"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)
wrong_formula(acceleration RIGHT "-wave.frequency * wave.frequency" WRONG "wave.frequency * wave.frequency"
              CAUGHT_BY Query.GradientsAndMotionAreDerivatives)

set(source sea_query.cpp)
wrong_formula(displaced RIGHT "found.offset + glm::vec2(local.value[0], local.value[2])"
              WRONG "found.offset - glm::vec2(local.value[0], local.value[2])"
              CAUGHT_BY Query.ThePointIsTheWaterThatIsDisplacedThere)
wrong_formula(layer RIGHT "sea.deviation * sea.largestGain" WRONG "sea.deviation / 6"
              CAUGHT_BY Query.RaysMeetTheSurfaceWhereItIsFirst)
wrong_formula(normal_up RIGHT "glm::cross(alongZ, alongX)" WRONG "glm::cross(alongX, alongZ)"
              CAUGHT_BY Query.BadInputIsNamedOrDefined)
wrong_formula(normal_stretch RIGHT "glm::mat2x3(g.z, g.x, d.w, d.w, g.y, g.w)" WRONG "glm::mat2x3(-g.z, g.x, d.w, d.w, g.y, g.w)" CAUGHT_BY Query.NormalsBelongToTheDisplacedSurface)
wrong_formula(newton RIGHT "-determinant" WRONG "determinant" CAUGHT_BY Query.ThePointIsTheWaterThatIsDisplacedThere)
wrong_formula(shortest RIGHT "2 * std::numbers::pi / shortestWavelength" WRONG "1 / shortestWavelength"
              CAUGHT_BY Query.ThePointIsTheWaterThatIsDisplacedThere)

wrong_formula(warped_normal RIGHT "patch * stretch[0]" WRONG "patch * stretch[1]"
              CAUGHT_BY Query.NormalsBelongToTheDisplacedSurface)

set(source warp.cpp)
wrong_formula(gradient RIGHT "std::sqrt(3.0 / 128)" WRONG "std::sqrt(3.0 / 64)" CAUGHT_BY Warp.GradientsHaveTheDeviationAskedFor)
wrong_formula(wave RIGHT "t * (8.0f - 16.0f * absolute(t))" WRONG "t * (8.0f - 8.0f * absolute(t))"
              CAUGHT_BY Warp.SlopesAreDerivatives)
wrong_formula(rate RIGHT "8.0f - 32.0f * absolute(t)" WRONG "8.0f - 16.0f * absolute(t)" CAUGHT_BY Warp.SlopesAreDerivatives)
wrong_formula(transposed RIGHT "sumOf(xz)" WRONG "sumOf(zx)"
              CAUGHT_BY Warp.SlopesAreDerivatives)

set(source whitecaps.cpp)
wrong_formula(lean RIGHT "glm::length(glm::dvec2(modes.constants[index].chop))"
              WRONG "static_cast<double>(modes.constants[index].chop.x)"
              CAUGHT_BY Whitecaps.CurvatureIsThatOfCrossingWaves)
wrong_formula(stretch RIGHT "chop * (kx * kx + kz * kz)" WRONG "chop * std::hypot(kx, kz)"
              CAUGHT_BY Whitecaps.JacobianSpreadIsTheSumOverModes)
wrong_formula(rate RIGHT "w * w * stretch * stretch * modes.variance[index]"
              WRONG "w * stretch * stretch * modes.variance[index]" CAUGHT_BY Whitecaps.CurvatureIsThatOfCrossingWaves)
wrong_formula(curvature RIGHT "a * (1 - a) - c * c" WRONG "a * (1 - a) + c * c"
              CAUGHT_BY Whitecaps.CurvatureIsThatOfCrossingWaves)
wrong_formula(mixed RIGHT "chop * kx * kz * stretch * modes.variance[index]"
              WRONG "kx * kz * stretch * modes.variance[index]" CAUGHT_BY Whitecaps.CurvatureIsThatOfCrossingWaves)
wrong_formula(other_bands RIGHT "c != cascade" WRONG "c == cascade" CAUGHT_BY Whitecaps.OtherBandsSoftenTheEdges)
wrong_formula(own_spread RIGHT "0.25 * bands[cascade].deviation" WRONG "bands[cascade].deviation"
              CAUGHT_BY Whitecaps.OtherBandsSoftenTheEdges)
wrong_formula(crossings RIGHT "band.rate / band.deviation / kTwoPi" WRONG "band.rate / band.deviation"
              CAUGHT_BY Whitecaps.ExpectedFoamIsTheShareThatBreaksAndWhatFades)
wrong_formula(lifetime RIGHT "mean + kFoamLifetime * fading" WRONG "mean + fading"
              CAUGHT_BY Whitecaps.ExpectedFoamIsTheShareThatBreaksAndWhatFades)
wrong_formula(bell RIGHT "coverage * bell / std::sqrt(kTwoPi) * step" WRONG "coverage * bell * step"
              CAUGHT_BY Whitecaps.ExpectedFoamIsTheShareThatBreaksAndWhatFades)
wrong_formula(decline RIGHT "1 / (kLull * kLull) - 1" WRONG "1 / kLull - 1"
              CAUGHT_BY Whitecaps.FoamDeclinesWithTheGainAsTheTailOfTheNormalDistribution)

set(source sea_change.cpp)
wrong_formula(growth RIGHT "30 * t * t * (1 - t) * (1 - t)" WRONG "15 * t * t * (1 - t) * (1 - t)"
              CAUGHT_BY SeaChange.SharesGrowFromZeroToOneWithoutAJumpInSpeedOrAcceleration)
wrong_formula(mixture RIGHT "share * (1 - share)" WRONG "-share * (1 - share)"
              CAUGHT_BY SeaChange.MomentsAreThoseOfTheMixedAmplitudes)
wrong_formula(lag RIGHT "std::polar(1.0, lag)" WRONG "std::polar(1.0, -lag)"
              CAUGHT_BY SeaChange.ANewChangeStartsFromWhatIsThere)

set(source trochoids.cpp)
wrong_formula(loops RIGHT "placed.steepness * waveNumber(placed) * placed.amplitude"
              WRONG "placed.steepness * placed.amplitude" CAUGHT_BY Trochoids.NeverLoop)
wrong_formula(energy RIGHT "2 * (1 - wanted.roughness) * variance" WRONG "(1 - wanted.roughness) * variance"
              CAUGHT_BY Trochoids.PickedOnesCarryEqualPartsOfTheSpectrum)
wrong_formula(inherited RIGHT "wave.amplitude * wave.amplitude + 2 * energy"
              WRONG "wave.amplitude * wave.amplitude" CAUGHT_BY Trochoids.PickedOnesCarryEqualPartsOfTheSpectrum)

set(source gain_field.cpp)
wrong_formula(across RIGHT "glm::mix(c - a, d - b, f.x) * perMetre" WRONG "glm::mix(c - a, d - b, f.x)"
              CAUGHT_BY GainMaps.AreLinearBetweenSamplesAndConstantBeyond)
wrong_formula(row RIGHT "static_cast<std::size_t>(cell.y)" WRONG "static_cast<std::size_t>(cell.x)"
              CAUGHT_BY GainMaps.AreLinearBetweenSamplesAndConstantBeyond)
