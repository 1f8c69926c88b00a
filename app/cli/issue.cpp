// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/findings_json.h"
#include "app/cli/issue_plan.h"
#include "app/cli/issuing.h"
#include "app/cli/project_job.h"
#include "app/cli/recipe_options.h"
#include "app/cli/registry_options.h"
#include "app/cli/signing_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/dcc/dcc_country.h"
#include "core/dcc/dcc_document.h"
#include "core/issue/issue_obstacles.h"
#include "core/project/template_choice.h"
#include "registry/cards/card_filling.h"
#include "registry/cards/card_register.h"
#include "registry/issued/file_signatures.h"
#include "ui/report/report_logo.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>

namespace dyncal {
namespace {

struct IssueOptions
{
    std::string project;
    IssueOrder order;
    std::string templateName;
    std::vector<std::string> languages;
    SigningOptions signing;
    bool json = false;
};

Result<void> checkAmendment(const IssueOrder &order)
{
    if ((order.amends > 0) == !order.reason.empty())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "An amendment needs both --amends NUMBER and --reason TEXT, which says what changed."),
            {}});
}

/// Template and languages are the recipe's unless they are given; what cards of the registry know
/// and nobody has typed is filled in.
Result<Recipe> chosen(Recipe recipe, const IssueOptions &options)
{
    takeTemplate(options.templateName, recipe);
    if (!options.languages.empty())
        recipe.certificate.languages = options.languages;
    if (const Result<Recipe> valid = parseRecipe(recipeJson(recipe)); !valid)
        return valid;
    return cardsAt(options.order.registry).map([&](const std::vector<Card> &cards) {
        return filledFromCards(recipe, cards);
    });
}

int refuse(const Findings &obstacles, bool json)
{
    if (json)
        std::cout << jsonText({{"findings", findingsJson(obstacles)}});
    reportFindings(obstacles);
    std::cerr << "No certificate was issued.\n";
    return static_cast<int>(ExitCode::Blocked);
}

int conclude(const IssuedCertificate &issued, const Findings &cautions, bool json)
{
    const CertificateRecord &record = issued.record;
    reportFindings(cautions);
    // As it stands in the files: the service that sealed it said nothing of its name.
    const std::string signer
        = issued.isSigned ? checkFolderSignatures(issued.folder, {}).signer : std::string();
    if (json)
        std::cout << jsonText({{"number", record.number}, {"folder", issued.folder},
            {"state", certificateStateName(record.state)}, {"head", record.head},
            {"files", record.files}, {"signed", issued.isSigned}, {"signer", textOrNull(signer)},
            {"time_stamp_authority", textOrNull(issued.authority)},
            {"findings", findingsJson(cautions)}});
    else
        std::cout << "Certificate " << record.number << ", " << certificateStateName(record.state)
                  << (issued.isSigned ? ", signed by " + presentable(signer) : ", not signed")
                  << ": " << presentable(issued.folder) << '\n';
    return static_cast<int>(ExitCode::Done);
}

/// CER-011: a certificate that is issued stays as it is, also where a signature is asked for now.
Findings signatureCautions(const IssuedCertificate &issued, const SigningOrder &signing)
{
    if (issued.isSigned || !signing.isSigned())
        return {};
    return {{.id = "CER-011",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "Certificate %1 was issued before, without a signature, and stays so; for one that is signed issue an amendment by --amends %1 --reason TEXT."),
            {std::to_string(issued.record.number)}}}};
}

/// Languages that were asked for come before those of the template.
Result<ChosenTemplate> templateOf(const Recipe &recipe, const IssueOptions &options)
{
    Result<ChosenTemplate> chosen = drawableTemplate(recipe.certificate.templateName);
    if (chosen && !options.languages.empty())
        chosen->layout.languages = options.languages;
    return chosen;
}

Result<IssueAnswer> issueJob(ProjectState job, const IssueOptions &options)
{
    const Result<Recipe> recipe = chosen(job.recipe, options);
    if (!recipe)
        return tl::unexpected<Error>(recipe.error());
    const Result<ChosenTemplate> layout = templateOf(*recipe, options);
    if (!layout)
        return tl::unexpected<Error>(layout.error());
    job.recipe = withKeptTemplate(*recipe, *layout);
    const PipelineOutcome outcome = calibrate(*job.captures, job.recipe);
    if (outcome.error && outcome.error->kind != ErrorKind::DataBlocked)
        return tl::unexpected<Error>(*outcome.error);
    Findings obstacles = issueObstacles(
        outcome, issuedRecipe(job.recipe, "1", options.order.names), options.order.names);
    if (!obstacles.empty())
        return IssueAnswer{{}, std::move(obstacles)};
    return issueCertificate(job, outcome, *layout, options.order)
        .map([&](IssuedCertificate issued) {
            const bool hasDcc = issued.record.files.contains(kDccFile); // one of long ago has none
            Findings cautions = signatureCautions(issued, options.order.signing);
            if (hasDcc)
                std::ranges::copy(countryCautions(job.recipe), std::back_inserter(cautions));
            return IssueAnswer{std::move(issued), std::move(cautions)};
        });
}

Result<void> checkPlanned(const IssueOrder &order)
{
    if (order.amends == 0 && order.number == 0)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "--number and --amends are of one certificate, and a plan is of many; issue that sensor's project by itself."),
            {}});
}

/// Paths as given hold in the plan's folder too.
IssueOptions inPlansFolder(IssueOptions options)
{
    const auto isAddress = options.order.registry.find("://") != std::string::npos;
    options.order.output = std::filesystem::absolute(options.order.output).string();
    if (isTemplateFile(options.templateName))
        options.templateName = std::filesystem::absolute(options.templateName).string();
    if (!options.order.registry.empty() && !isAddress)
        options.order.registry = std::filesystem::absolute(options.order.registry).string();
    return options;
}

int issueAll(const IssueOptions &options)
{
    if (const Result<void> planned = checkPlanned(options.order); !planned)
        return report(planned.error());
    const IssueOptions absolute = inPlansFolder(options);
    return issuePlan(
        options.project, [&](ProjectState job) { return issueJob(std::move(job), absolute); },
        options.json);
}

int issueOne(const IssueOptions &options)
{
    Result<ProjectState> job = readProjectJob(options.project);
    if (!job)
        return report(job.error());
    const Result<IssueAnswer> answer = issueJob(std::move(*job), options);
    if (!answer)
        return report(answer.error());
    return answer->issued ? conclude(*answer->issued, answer->findings, options.json)
                          : refuse(answer->findings, options.json);
}

int issue(IssueOptions options)
{
    const Result<std::string> now = currentUtc();
    if (!now)
        return report(now.error());
    options.order.names.utc = *now;
    if (const Result<void> whole = checkAmendment(options.order); !whole)
        return report(whole.error());
    // Before a number is taken: a wrong PIN must not cost one.
    const Result<SigningOrder> signing = signingOrder(options.signing, *now);
    if (!signing)
        return report(signing.error());
    options.order.signing = *signing;
    return isPlan(options.project) ? issueAll(options) : issueOne(options);
}

void declareNames(CLI::App &verb, IssueOrder &order)
{
    verb.add_option("--by", order.names.by, "Who issues it; else the operator of the recipe")
        ->type_name("NAME");
    verb.add_option("--reviewed-by", order.names.reviewedBy, "Who reviewed it")->type_name("NAME");
    verb.add_option("--amends", order.amends, "Number of the certificate that it replaces")
        ->check(CLI::PositiveNumber)
        ->type_name("NUMBER");
    verb.add_option("--reason", order.reason, "Of the amendment: what changed")->type_name("TEXT");
}

} // namespace

void addIssue(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<IssueOptions>();
    CLI::App *verb = program.add_subcommand(
        "issue", "Issue the certificate of a project: numbered, registered, frozen in DIR/NUMBER/");
    verb->add_option("project", options->project,
            "A project, or the plan of a batch (.jsonl), of which every sensor that is ready is issued")
        ->required()
        ->type_name("PROJECT|PLAN");
    verb->add_option("-o,--output", options->order.output, "Folder that gets the folder NUMBER")
        ->required()
        ->type_name("DIR");
    declareRegistry(*verb, options->order.registry);
    verb->add_option("--number", options->order.number, "Go on with this reserved number")
        ->check(CLI::PositiveNumber)
        ->type_name("NUMBER");
    declareTemplate(*verb, options->templateName);
    verb->add_option("--languages", options->languages,
            "One or two of en, sv and de; else those of the recipe")
        ->delimiter(',')
        ->type_name("en,sv");
    declareNames(*verb, options->order);
    declareSigning(*verb, options->signing);
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer(
        "Example:\n  dyncal issue job.dyncal -o certificates --by \"A. Berg\" --key lab.p12 --pin-fd 3 3< pin\n"
        "  dyncal issue job.dyncal -o certificates --amends 17 --reason \"serial number corrected\" --unsigned\n"
        "  dyncal issue plan.jsonl -o certificates --by \"A. Berg\" --unsigned");
    verb->callback([options, &action] { action = [options] { return issue(*options); }; });
}

} // namespace dyncal
