// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// The steps of the method, in the order in which they are computed; stage_table.cpp describes
/// each.
enum class StageId {
    Captures, ///< roles, units, exclusions applied; recordings checked
    Arrivals, ///< where the records of DUTs and side sensors begin to move
    Expected, ///< the shock from these arrivals, before any model
    Window, ///< start, response window, remap
    Spectrum, ///< power spectra and resonances
    Components, ///< PCA, residuals, average
    ModelInput, ///< resampled, cut
    Decomposition, ///< Hankel singular values, suggested order
    Model, ///< poles, fit
    Shock, ///< velocity, states, pressure step
    Response, ///< frequency response, characteristics, sensitivity
    Assessment, ///< of the model: uncertainties, shots compared; no response waits for it
    Evidence, ///< what all orders show; no result waits for it
    MonteCarlo, ///< of the pressure step; nothing waits for it
};
inline constexpr int kStageCount = 14;
inline constexpr StageId kLastStage = StageId::MonteCarlo;

} // namespace dyncal
