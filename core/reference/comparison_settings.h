// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <memory>
#include <optional>
#include <string>

namespace dyncal {

/// A reference transducer described as a second-order sensor; all u at k = 1.
struct ReferenceModel
{
    double sensitivity = 0.0; ///< in ComparisonSettings::unit
    double u_sensitivity = 0.0;
    double f0_Hz = 0.0;
    double u_f0_Hz = 0.0;
    double zeta = 0.0;
    double u_zeta = 0.0;

    bool operator==(const ReferenceModel &) const = default;
};

/// The file that says what a reference transducer is, as it was read.
struct ReferenceSource
{
    std::string sha256;
    std::string content;
};

/// Recipe section "comparison": a reference transducer beside the DUT.
struct ComparisonSettings
{
    bool enabled = false;
    std::string channel; ///< "" = the one with the role of the reference
    std::string source; ///< file, relative to the recipe; "" = none
    std::string sha256; ///< that it must have; "" = any
    std::string quantityId; ///< of the list in a certificate in XML
    std::string certificate; ///< its number, where the file states none
    std::string due; ///< day until which it holds
    std::optional<ReferenceModel> model; ///< instead of a file
    std::string unit = "V/Pa"; ///< of the reference's sensitivity
    double delay_s = 0.0; ///< by which the step reaches the reference later than the DUT
    std::optional<double> u_delay_s;
    double correlationWithStep = 0.0; ///< of the reference's sensitivity and the computed step

    /// What `source` holds; no key of the recipe: whoever reads a recipe reads the file too.
    std::shared_ptr<const ReferenceSource> loaded;

    bool operator==(const ComparisonSettings &other) const;
};

} // namespace dyncal
