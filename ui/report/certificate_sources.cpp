// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/certificate_sources.h"

#include "core/base/version.h"
#include "core/pipeline/stage_table.h"

namespace dyncal {

CertificateSources certificateSources(
    const CalibrationResults &results, const Recipe &recipe, const std::string &createdUtc)
{
    CertificateSources sources;
    if (results.captures)
        sources.captures = &results.captures->set;
    sources.window = results.window.get();
    sources.shock = results.shock.get();
    sources.input = results.input.get();
    if (results.decomposition)
        sources.suggestion = &results.decomposition->suggestion;
    sources.model = results.model.get();
    sources.assessment = results.assessment.get();
    sources.response = results.response.get();
    sources.evidence = results.evidence.get();
    sources.order = recipe.realization.order;
    sources.orderReason = recipe.realization.adoptedReason;
    sources.coverage = recipe.uncertainty.coverage;
    sources.findings = allFindings(results);
    for (const Acknowledgement &seen : recipe.acknowledge)
        sources.acknowledgements.push_back({seen.finding, seen.shot, seen.reason});
    sources.fields = recipe.certificate.fields;
    if (!recipe.certificate.languages.empty())
        sources.language = recipe.certificate.languages.front();
    sources.createdUtc = createdUtc;
    sources.softwareVersion = versionText();
    sources.softwareBuild = buildText();
    return sources;
}

} // namespace dyncal
