// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/issue/issued_recipe.h"
#include "core/pipeline/pipeline.h"
#include "core/project/template_choice.h"
#include "core/signing/signing_order.h"
#include "registry/certificates/certificate_register.h"
#include "ui/session/project_state.h"

#include <string>

namespace dyncal {

/// What `dyncal issue` is asked for.
struct IssueOrder
{
    std::string output; ///< folder that gets the folder of the certificate
    std::string registry; ///< address; empty: that of this user
    IssueNames names;
    Index number = 0; ///< a reserved one; 0: the job's own, or the next
    Index amends = 0; ///< 0: none
    std::string reason;
    SigningOrder signing = {}; ///< who signs, at the moment of `names`
};

/// A certificate that lies in its folder and stands in the registry.
struct IssuedCertificate
{
    CertificateRecord record;
    std::string folder;
    bool isSigned = false;
    std::string authority = {}; ///< whose time stamp it got now; empty: none, or issued before
};

/// Numbers, writes and registers the certificate of a job that has no obstacles (issueObstacles),
/// whose recipe names the kept copy of its template (withKeptTemplate): reserves the number, writes
/// OUTPUT/NUMBER/, marks it issued, each as a whole. After a failure the same call goes on with the
/// same number; a job that is issued already is answered without writing anything. Fails as
/// CertificateRegister, writeIssuedFolder, the drawing and the signing do.
Result<IssuedCertificate> issueCertificate(const ProjectState &job, const PipelineOutcome &outcome,
    const ChosenTemplate &chosen, const IssueOrder &order);

} // namespace dyncal
