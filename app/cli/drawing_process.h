// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/certificate_issue.h"
#include "core/project/template_choice.h"
#include "core/results/run_files.h"
#include "ui/report/report_figures.h"

#include <string>
#include <vector>

namespace dyncal {

/// certificate.pdf and the plots of a run, drawn in a process of its own: Qt ends a process where
/// it gets no memory, so it draws in a copy of this one, which holds all that is to be drawn and
/// hands the bytes back (docs/adr/0017-drawing-process.md). Fails (Internal) if that process dies.
/// Only for a program without a QApplication.
Result<std::vector<DrawnFile>> drawWithoutWindow(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const ChosenTemplate &chosen);

/// certificate.pdf alone, issued, with the figures of sections that the results do not know of.
Result<std::vector<DrawnFile>> drawWithoutWindow(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const ChosenTemplate &chosen,
    const CertificateIssue &issue, const std::vector<FigureMaker> &moreFigures = {});

/// The same of a document of words and tables, as one file of that name.
Result<std::vector<DrawnFile>> drawWithoutWindow(
    const CertificateData &document, const std::string &name);

} // namespace dyncal
