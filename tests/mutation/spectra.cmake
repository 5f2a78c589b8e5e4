# Spectra and spreadings; see WrongFormula.cmake.

set(source spectrum.cpp)
wrong_formula(capillarity RIGHT "(kGravity * k + kCapillarity * k * k * k) * std::tanh(k * depth)"
              WRONG "(kGravity * k + 0.5 * kCapillarity * k * k * k) * std::tanh(k * depth)"
              CAUGHT_BY Dispersion.HasItsLimits)
wrong_formula(depth RIGHT "(kGravity * k + kCapillarity * k * k * k) * std::tanh(k * depth)"
              WRONG "(kGravity * k + kCapillarity * k * k * k) * std::tanh(0.5 * k * depth)"
              CAUGHT_BY Dispersion.HasItsLimits)
wrong_formula(frequency_2pi RIGHT "(kGravity * k + kCapillarity * k * k * k) * std::tanh(k * depth)"
              WRONG "(kGravity * k + kCapillarity * k * k * k) * std::tanh(k * depth) / (2 * kPi)"
              CAUGHT_BY Dispersion.HasItsLimits)
wrong_formula(group_capillarity RIGHT "3 * kCapillarity * k * k" WRONG "2 * kCapillarity * k * k"
              CAUGHT_BY Dispersion.GroupSpeedIsTheDerivative)
wrong_formula(group_depth RIGHT "depth / (c * c)" WRONG "depth / c" CAUGHT_BY Dispersion.GroupSpeedIsTheDerivative)
wrong_formula(group_half RIGHT "slope / (2 * w)" WRONG "slope / w" CAUGHT_BY Dispersion.GroupSpeedIsTheDerivative)
wrong_formula(wind_height RIGHT "kWindRatio * sea.windSpeed" WRONG "sea.windSpeed"
              CAUGHT_BY Spectra.PiersonMoskowitzHasItsClosedForm)
wrong_formula(pm_exponent RIGHT "-kPmBeta * std::pow(pmFrequency(sea) / w, 4)"
              WRONG "-1.25 * std::pow(pmFrequency(sea) / w, 4)" CAUGHT_BY Spectra.PiersonMoskowitzHasItsClosedForm)
wrong_formula(pm_tail RIGHT "kPmAlpha * kGravity * kGravity * std::pow(w, -5)"
              WRONG "kPmAlpha * kGravity * kGravity * std::pow(w, -4)"
              CAUGHT_BY Spectra.PiersonMoskowitzHasItsClosedForm)
wrong_formula(pm_peak RIGHT "0.8 * kPmBeta" WRONG "kPmBeta" CAUGHT_BY Spectra.PeakWhereTheirPeakFrequencySays)
wrong_formula(developed_cap RIGHT "kFullyDeveloped * sea.windSpeed * sea.windSpeed"
              WRONG "2 * kFullyDeveloped * sea.windSpeed * sea.windSpeed"
              CAUGHT_BY Spectra.JonswapMeetsPiersonMoskowitzWhenFullyDeveloped)
wrong_formula(jonswap_alpha
              RIGHT "0.076 * std::pow(sea.windSpeed * sea.windSpeed / (effectiveFetch(sea) * kGravity), 0.22)"
              WRONG "0.076 * std::pow(sea.windSpeed * sea.windSpeed / (effectiveFetch(sea) * kGravity), 0.33)"
              CAUGHT_BY Spectra.JonswapPeaksWithItsOvershoot)
wrong_formula(jonswap_alpha_gravity
              RIGHT "0.076 * std::pow(sea.windSpeed * sea.windSpeed / (effectiveFetch(sea) * kGravity), 0.22)"
              WRONG "0.076 * std::pow(sea.windSpeed * sea.windSpeed / effectiveFetch(sea), 0.22)"
              CAUGHT_BY Spectra.JonswapPeaksWithItsOvershoot)
wrong_formula(jonswap_peak RIGHT "22 * std::cbrt(kGravity * kGravity / (sea.windSpeed * effectiveFetch(sea)))"
              WRONG "3.5 * std::cbrt(kGravity * kGravity / (sea.windSpeed * effectiveFetch(sea)))"
              CAUGHT_BY Spectra.JonswapPeaksWithItsOvershoot)
wrong_formula(jonswap_sides RIGHT "w <= peak ? 0.07 : 0.09" WRONG "w <= peak ? 0.09 : 0.07"
              CAUGHT_BY Spectra.JonswapIsNarrowerBelowItsPeak)
wrong_formula(jonswap_width RIGHT "-0.5 * d * d" WRONG "-d * d"
              CAUGHT_BY Spectra.JonswapMeetsPiersonMoskowitzWhenFullyDeveloped)
wrong_formula(jonswap_cutoff RIGHT "-1.25 * std::pow(peak / w, 4)" WRONG "-0.74 * std::pow(peak / w, 4)"
              CAUGHT_BY Spectra.JonswapPeaksWithItsOvershoot)
wrong_formula(phillips_norm RIGHT "4 * kPmBeta * std::pow(pmFrequency(sea), 4)"
              WRONG "kPmBeta * std::pow(pmFrequency(sea), 4)" CAUGHT_BY Spectra.PhillipsHasTheVarianceOfTheDevelopedSea)
wrong_formula(phillips_shape RIGHT "4 * variance * ratio4 / w" WRONG "4 * variance * ratio4 / (w * w)"
              CAUGHT_BY Spectra.PhillipsHasTheVarianceOfTheDevelopedSea)
wrong_formula(phillips_peak RIGHT "std::pow(0.8, 0.25) * kGravity / sea.windSpeed" WRONG "kGravity / sea.windSpeed"
              CAUGHT_BY Spectra.PeakWhereTheirPeakFrequencySays)
wrong_formula(tma_square RIGHT "t * t / (1 + u)" WRONG "t / (1 + u)" CAUGHT_BY Spectra.TmaIsJonswapTimesKitaigorodskii)
wrong_formula(tma_two_kh RIGHT "2 * kh / std::sinh(2 * kh)" WRONG "kh / std::sinh(kh)"
              CAUGHT_BY Spectra.TmaIsJonswapTimesKitaigorodskii)
wrong_formula(deep_wave_number RIGHT "1.5 * w * w / (kCapillarity * p * scale)"
              WRONG "3 * w * w / (kCapillarity * p * scale)"
              CAUGHT_BY Unified.CarriesOneVarianceOverFrequenciesAndWaveNumbers)
wrong_formula(unified_group_speed
              RIGHT "unifiedSpectrum(unifiedSea(sea.windSpeed, sea.fetch), k) / groupSpeed(k, kDeep)"
              WRONG "unifiedSpectrum(unifiedSea(sea.windSpeed, sea.fetch), k) * groupSpeed(k, kDeep)"
              CAUGHT_BY Unified.CarriesOneVarianceOverFrequenciesAndWaveNumbers)
wrong_formula(swell_height RIGHT "0.25 * hs * hs" WRONG "hs * hs / 16" CAUGHT_BY Spectra.SwellHasItsHeightAndPeriod)
wrong_formula(swell_gamma RIGHT "std::tgamma(kSwellShape)" WRONG "std::tgamma(kSwellShape + 1)"
              CAUGHT_BY Spectra.SwellHasItsHeightAndPeriod)
wrong_formula(swell_shape RIGHT "kSwellShape + 0.25" WRONG "kSwellShape" CAUGHT_BY Spectra.SwellHasItsHeightAndPeriod)
wrong_formula(gain_of_energy RIGHT "gain * gain" WRONG "gain" CAUGHT_BY Spectra.OctaveGainScalesAmplitudes)
wrong_formula(gain_octave RIGHT "kFirst - std::log2(2 * kPi / k)" WRONG "kFirst - std::log2(1 / k)"
              CAUGHT_BY Spectra.OctaveGainScalesAmplitudes)
wrong_formula(age_inverted RIGHT "sea.windSpeed * peak / kGravity" WRONG "kGravity / (sea.windSpeed * peak)"
              CAUGHT_BY Spreadings.HasselmannHasItsExponents)
wrong_formula(sharpening_inverted RIGHT "std::tanh(1 / point.relative)" WRONG "std::tanh(point.relative)"
              CAUGHT_BY Spreadings.SwellSharpeningAddsToTheExponentAndKeepsTheIntegral)
wrong_formula(sharpening_square RIGHT "sea.swellSharpening * sea.swellSharpening" WRONG "sea.swellSharpening"
              CAUGHT_BY Spreadings.SwellSharpeningAddsToTheExponentAndKeepsTheIntegral)
wrong_formula(table_direction RIGHT "theta + sea_.windDirection" WRONG "theta - sea_.windDirection"
              CAUGHT_BY Table.DirectionsAreThoseOfTheWorld)
wrong_formula(skewness RIGHT "0.04 - 0.033 * std::min(windSpeed, 14.0)"
              WRONG "0.04 - 0.33 * std::min(windSpeed, 14.0)" CAUGHT_BY Lean.HasTheSkewnessOfThePaper)
wrong_formula(no_dw_dk RIGHT "energyGain(sea, k) * groupSpeed(k, sea.depth) / k"
              WRONG "energyGain(sea, k) / k" CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(dk_dw RIGHT "energyGain(sea, k) * groupSpeed(k, sea.depth) / k"
              WRONG "energyGain(sea, k) / groupSpeed(k, sea.depth) / k"
              CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(no_1_over_k RIGHT "energyGain(sea, k) * groupSpeed(k, sea.depth) / k"
              WRONG "energyGain(sea, k) * groupSpeed(k, sea.depth)"
              CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(phase_speed RIGHT "energyGain(sea, k) * groupSpeed(k, sea.depth) / k"
              WRONG "energyGain(sea, k) * w / (k * k)"
              CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(transposed RIGHT "std::atan2(kz, kx)" WRONG "std::atan2(kx, kz)"
              CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(wind_direction RIGHT "windSeaSpreading(sea, w, direction - sea.windDirection)"
              WRONG "windSeaSpreading(sea, w, direction + sea.windDirection)"
              CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(swell_direction RIGHT "direction - swell.direction" WRONG "direction + swell.direction"
              CAUGHT_BY WaveNumberSpectrum.IsSTimesDTimesGroupSpeedOverWaveNumber)
wrong_formula(variance_dw_dk RIGHT "spectrumAt(sea, angularFrequency(k, sea.depth), k) * groupSpeed(k, sea.depth)"
              WRONG "spectrumAt(sea, angularFrequency(k, sea.depth), k)"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(simpson RIGHT "sum * step / 3" WRONG "sum * step / 2"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(log_step RIGHT "weight * k * f(k)" WRONG "weight * f(k)"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(slopes_k_squared RIGHT "k * k * groupSpeed(k, sea.depth) * energyGain(sea, k) * density"
              WRONG "k * groupSpeed(k, sea.depth) * energyGain(sea, k) * density"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(slopes_gain RIGHT "k * k * groupSpeed(k, sea.depth) * energyGain(sea, k) * density"
              WRONG "k * k * groupSpeed(k, sea.depth) * density" CAUGHT_BY Spectra.OctaveGainScalesAmplitudes)
wrong_formula(along_share RIGHT "distribution(theta) * c * c" WRONG "distribution(theta) * c"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(slopes_across RIGHT "result.upwind += up" WRONG "result.crosswind += up"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(slopes_swell RIGHT "theta - (swell.direction - sea.windDirection)" WRONG "theta - swell.direction"
              CAUGHT_BY WaveNumberSpectrum.HoldsTheVarianceAndSlopesOfTheFrequencySpectrum)
wrong_formula(significant_height RIGHT "4 * std::sqrt(elevationVariance(sea, 0, 1e4))"
              WRONG "2 * std::sqrt(2 * elevationVariance(sea, 0, 1e4))"
              CAUGHT_BY Spectra.PiersonMoskowitzHasItsClosedForm)
wrong_formula(second_moment RIGHT "w * w * spectrumAt(sea, w, k)" WRONG "w * spectrumAt(sea, w, k)"
              CAUGHT_BY Spectra.ZeroCrossingPeriodHasItsClosedForm)
wrong_formula(mean_period RIGHT "2 * kPi * std::sqrt(elevationVariance(sea, 0, 1e4) / m2)"
              WRONG "std::sqrt(elevationVariance(sea, 0, 1e4) / m2)"
              CAUGHT_BY Spectra.ZeroCrossingPeriodHasItsClosedForm)
wrong_formula(peak_period RIGHT "2 * kPi / best" WRONG "1 / best"
              CAUGHT_BY Table.IsLinearBetweenItsEntriesAndEndsInATail)
wrong_formula(peak_wavelength RIGHT "2 * kPi / waveNumberOf(lowest, sea.depth)"
              WRONG "1 / waveNumberOf(lowest, sea.depth)" CAUGHT_BY Table.TheLayoutHoldsItsLongestTrain)
wrong_formula(slopes_upwind RIGHT "0.00316 * windSpeed" WRONG "0.00192 * windSpeed"
              CAUGHT_BY RealSea.HasTheMeasuredSlopesAndWhitecaps)
wrong_formula(slopes_crosswind RIGHT "0.003 + 0.00192 * windSpeed" WRONG "0.00192 * windSpeed"
              CAUGHT_BY RealSea.HasTheMeasuredSlopesAndWhitecaps)
wrong_formula(whitecap_factor RIGHT "3.84e-6 * std::pow(windSpeed, 3.41)" WRONG "2.95e-6 * std::pow(windSpeed, 3.41)"
              CAUGHT_BY RealSea.HasTheMeasuredSlopesAndWhitecaps)
wrong_formula(whitecap_exponent RIGHT "3.84e-6 * std::pow(windSpeed, 3.41)" WRONG "3.84e-6 * std::pow(windSpeed, 3.52)"
              CAUGHT_BY RealSea.HasTheMeasuredSlopesAndWhitecaps)

set(source unified.cpp)
wrong_formula(phase_speed RIGHT "1 + ratio * ratio" WRONG "1 + ratio"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(gamma_log RIGHT "6 * std::log10(age)" WRONG "6 * std::log(age)"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(peak_width RIGHT "1 + 4 / (age * age * age)" WRONG "1 + 4 / age"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(cutoff RIGHT "-1.25 * ratio * ratio" WRONG "-1.25 * ratio"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(fetch RIGHT "k0 * fetch / kFetchScale" WRONG "fetch / kFetchScale"
              CAUGHT_BY Unified.HasThePapersParameters)
wrong_formula(peak RIGHT "k0 * sea.inverseAge * sea.inverseAge" WRONG "k0 * sea.inverseAge"
              CAUGHT_BY Unified.HasThePapersParameters)
wrong_formula(roughness RIGHT "3.7e-5 / k0 * std::pow(sea.inverseAge, 0.9)" WRONG "3.7e-5 / k0"
              CAUGHT_BY Unified.HasThePapersParameters)
wrong_formula(friction RIGHT "kKarman * windSpeed / std::log(10 / roughness)"
              WRONG "windSpeed / std::log(10 / roughness)" CAUGHT_BY Unified.HasThePapersParameters)
wrong_formula(damping RIGHT "-age / std::sqrt(10)" WRONG "-age / 10"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(long_half RIGHT "0.5 * 6e-3 * std::pow(age, 0.55) * peakSpeed / c * damped"
              WRONG "6e-3 * std::pow(age, 0.55) * peakSpeed / c * damped"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(long_speeds RIGHT "0.5 * 6e-3 * std::pow(age, 0.55) * peakSpeed / c * damped"
              WRONG "0.5 * 6e-3 * std::pow(age, 0.55) * c / peakSpeed * damped"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(short_friction RIGHT "push < 0 ? push : 3 * push" WRONG "push"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(short_half RIGHT "0.5 * alpha * kSlowestSpeed / c" WRONG "alpha * kSlowestSpeed / c"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(short_band RIGHT "-0.25 * d * d" WRONG "-0.5 * d * d"
              CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(curvature RIGHT "k * k * k" WRONG "k * k * k * k" CAUGHT_BY Unified.HasTheValuesOfAnIndependentEvaluation)
wrong_formula(asymmetry RIGHT "0.25 * std::log(2.0)" WRONG "0.25" CAUGHT_BY Unified.SpreadsByItsAsymmetry)
wrong_formula(asymmetry_friction RIGHT "0.13 * sea.friction / kSlowestSpeed" WRONG "0.13 * sea.friction"
              CAUGHT_BY Unified.SpreadsByItsAsymmetry)
wrong_formula(asymmetry_speeds RIGHT "std::pow(c / peakSpeed, 2.5)" WRONG "std::pow(peakSpeed / c, 2.5)"
              CAUGHT_BY Unified.SpreadsByItsAsymmetry)

set(source spreading.cpp)
wrong_formula(gamma_norm RIGHT "gammaRatio(s) / (2 * std::sqrt(kPi))" WRONG "gammaRatio(s) / (2 * kPi)"
              CAUGHT_BY Spreadings.CosinePowerHasTheGammaNorm)
wrong_formula(gamma_series RIGHT "-19.0 / 8192" WRONG "19.0 / 8192" CAUGHT_BY Spreadings.CosinePowerHasTheGammaNorm)
wrong_formula(half_angle RIGHT "0.5 * wrapped(theta)" WRONG "wrapped(theta)"
              CAUGHT_BY Spreadings.CosinePowerHasTheGammaNorm)
wrong_formula(cos_2s RIGHT "2 * shape" WRONG "shape" CAUGHT_BY Spreadings.CosinePowerHasTheGammaNorm)
wrong_formula(cos2_norm RIGHT "2 / kPi" WRONG "4 / kPi" CAUGHT_BY Spreadings.IntegrateToOneAtEveryFrequency)
wrong_formula(mitsuyasu_age RIGHT "11.5 * std::pow(point.inverseAge, -2.5)"
              WRONG "11.5 * std::pow(point.inverseAge, 2.5)" CAUGHT_BY Spreadings.MitsuyasuHasItsExponents)
wrong_formula(mitsuyasu_sides RIGHT "x <= 1 ? 5.0 : -2.5" WRONG "x <= 1 ? -2.5 : 5.0"
              CAUGHT_BY Spreadings.MitsuyasuHasItsExponents)
wrong_formula(hasselmann_age RIGHT "-2.33 - 1.45 * (point.inverseAge - 1.17)"
              WRONG "-2.33 + 1.45 * (point.inverseAge - 1.17)" CAUGHT_BY Spreadings.HasselmannHasItsExponents)
wrong_formula(hasselmann_long RIGHT "6.97 * std::pow(x, 4.06)" WRONG "9.77 * std::pow(x, 4.06)"
              CAUGHT_BY Spreadings.HasselmannHasItsExponents)
wrong_formula(donelan_long RIGHT "2.61 * std::pow(relative, 1.3)" WRONG "2.28 * std::pow(relative, 1.3)"
              CAUGHT_BY Spreadings.DonelanAndBannerHaveTheirCoefficients)
wrong_formula(donelan_middle RIGHT "2.28 * std::pow(relative, -1.3)" WRONG "2.28 * std::pow(relative, 1.3)"
              CAUGHT_BY Spreadings.DonelanAndBannerHaveTheirCoefficients)
wrong_formula(banner_tail RIGHT "0.8393 * std::exp(-0.567 * std::log(relative * relative))"
              WRONG "0.8393 * std::exp(-0.567 * std::log(relative))"
              CAUGHT_BY Spreadings.DonelanAndBannerHaveTheirCoefficients)
wrong_formula(sech_norm RIGHT "2 * std::tanh(beta * kPi)" WRONG "2" CAUGHT_BY Spreadings.IntegrateToOneAtEveryFrequency)
wrong_formula(sech_square RIGHT "sech * sech" WRONG "sech" CAUGHT_BY Spreadings.IntegrateToOneAtEveryFrequency)
wrong_formula(elfouhaily_norm RIGHT "1 / kPi" WRONG "1 / (2 * kPi)" CAUGHT_BY Unified.SpreadsByItsAsymmetry)
wrong_formula(elfouhaily_double RIGHT "shape * (2 * c * c - 1)" WRONG "shape * c"
              CAUGHT_BY Unified.SpreadsByItsAsymmetry)
wrong_formula(sharpened_norm RIGHT "1 / (2 * sum)" WRONG "1 / sum"
              CAUGHT_BY Spreadings.SwellSharpeningAddsToTheExponentAndKeepsTheIntegral)

set(source spectrum_table.cpp)
wrong_formula(hertz RIGHT "place.tail * density / kTwoPi" WRONG "place.tail * density"
              CAUGHT_BY Table.IsLinearBetweenItsEntriesAndEndsInATail)
wrong_formula(tail RIGHT "std::pow(f.back() / frequency, 5)" WRONG "std::pow(f.back() / frequency, 4)"
              CAUGHT_BY Table.IsLinearBetweenItsEntriesAndEndsInATail)
wrong_formula(trapezium RIGHT "0.5 * (density[i] + density[wraps ? 0 : i + 1])"
              WRONG "density[i] + density[wraps ? 0 : i + 1]" CAUGHT_BY Table.DirectionsAreThoseOfTheWorld)
wrong_formula(direction_norm RIGHT "std::lerp(at(place.low), at(place.high), place.share) / total"
              WRONG "std::lerp(at(place.low), at(place.high), place.share)"
              CAUGHT_BY Table.DirectionsAreThoseOfTheWorld)
wrong_formula(peak RIGHT "kTwoPi * table.frequency[best]" WRONG "table.frequency[best]"
              CAUGHT_BY Table.IsLinearBetweenItsEntriesAndEndsInATail)
