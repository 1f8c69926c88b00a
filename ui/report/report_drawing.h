// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/certificate/certificate_issue.h"
#include "core/project/template_choice.h"
#include "core/results/run_files.h"
#include "ui/report/report_figures.h"

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

namespace dyncal {

enum class ReportParts { Certificate, CertificateAndPlots };

/// Draws certificate.pdf and, where asked for, plots/NN-name.svg of one set of results in memory,
/// in steps, and makes with the plots the dcc.xml that says the same: drawing needs the thread of
/// the window, which must stay free to answer. All texts are in the language of the recipe's
/// certificate, whatever that of the window; `createdUtc` (ISO 8601 with Z) is printed and makes
/// the bytes reproducible. A draft unless `issue` makes it a certificate; `chosen` says what it
/// shows; `moreFigures` are those of sections that the results do not know of. Needs a
/// QApplication.
class ReportDrawing
{
public:
    ReportDrawing(const CalibrationResults &results, const Recipe &recipe,
        const std::string &createdUtc, ReportParts parts, const ChosenTemplate &chosen = {},
        const std::optional<CertificateIssue> &issue = {},
        const std::vector<FigureMaker> &moreFigures = {});
    ~ReportDrawing();
    ReportDrawing(const ReportDrawing &) = delete;
    ReportDrawing &operator=(const ReportDrawing &) = delete;

    bool isDone() const;
    double fraction() const; ///< 0..1
    /// Draws until all is done or, at the end of a step, `budget` is used up. One step takes some
    /// ten milliseconds at most.
    void draw(std::chrono::milliseconds budget);

    /// What was drawn, the certificate first; with plots of a draft the DCC behind it where there
    /// is a response. Internal if drawing failed.
    Result<std::vector<DrawnFile>> take();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace dyncal
