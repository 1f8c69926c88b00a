// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_drawing.h"

#include "core/certificate/certificate_issue.h"
#include "core/dcc/dcc_document.h"
#include "ui/plot/widget/plot_export.h"
#include "ui/report/certificate_dcc.h"
#include "ui/report/certificate_pdf.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_language.h"
#include "ui/report/reproducible_output.h"

#include <QApplication>
#include <QBuffer>
#include <QElapsedTimer>

#include <algorithm>

namespace dyncal {

namespace {

constexpr QSize kPlotSize(900, 480);
/// Assumed number of blocks until the layout of the certificate is known; only for the progress.
constexpr std::size_t kUsualBlocks = 150;

std::string plotName(std::size_t number, const std::string &id)
{
    return (number < 10 ? "plots/0" : "plots/") + std::to_string(number) + "-" + id + ".svg";
}

} // namespace

struct ReportDrawing::Private
{
    CalibrationResults results; ///< the makers point into it
    Recipe recipe;
    std::optional<CertificateIssue> issue;
    CertificateData data;
    ReportLanguage language;
    std::vector<FigureMaker> makers;
    bool plots = true;
    std::vector<ReportFigure> figures;
    std::unique_ptr<CertificatePdf> certificate;
    std::vector<DrawnFile> drawn;
    std::size_t steps = 0;
    std::optional<Error> problem;

    Private(const CalibrationResults &shown, const Recipe &asked, const std::string &createdUtc,
        const ChosenTemplate &chosen, const std::optional<CertificateIssue> &issued)
        : results(shown)
        , recipe(asked)
        , issue(issued)
        , data(certificateOf(results, recipe, createdUtc, chosen, issue))
        , language(data.language)
        , makers(figureMakers(results))
    {
    }

    bool isDone() const
    {
        const std::size_t documents = plots ? figures.size() + 1 : 1;
        return problem || (steps >= makers.size() && drawn.size() >= documents);
    }

    std::size_t stepCount() const
    {
        const std::size_t blocks = certificate ? certificate->blockCount() : kUsualBlocks;
        return makers.size() + blocks + (plots ? makers.size() : 0) + 2;
    }

    void step()
    {
        const std::size_t number = steps++;
        if (number < makers.size())
            makeFigure(makers[number]);
        else if (!certificate)
            certificate = std::make_unique<CertificatePdf>(data, figures);
        else if (!certificate->isDrawn())
            certificate->drawNext();
        else if (drawn.empty())
            finishCertificate();
        else
            drawPlot(drawn.size() - 1);
    }

    void makeFigure(const FigureMaker &make)
    {
        if (std::optional<ReportFigure> figure = make())
            figures.push_back(std::move(*figure));
    }

    void finishCertificate()
    {
        Result<std::string> pdf = certificate->take();
        if (pdf)
            drawn.push_back({"certificate.pdf", std::move(*pdf)});
        else
            problem = pdf.error();
    }

    /// A draft's, behind the certificate that it belongs to, of a whole set of results; an issued
    /// one is signed before it is embedded (issuing).
    void addDcc()
    {
        if (plots && results.response && !issue && !drawn.empty())
            drawn.insert(
                drawn.begin() + 1, {kDccFile, certificateDcc(data, results, recipe, issue)});
    }

    void drawPlot(std::size_t index)
    {
        const PlotPicture picture{
            std::make_shared<const PlotContent>(figures[index].content), {}, {}, {}};
        QBuffer svg;
        svg.open(QIODevice::WriteOnly);
        if (!writePicture(picture, kPlotSize, "svg", svg))
            problem = nothingToDrawOn();
        drawn.push_back({plotName(index + 1, figures[index].id), svg.data().toStdString()});
    }
};

ReportDrawing::ReportDrawing(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, ReportParts parts, const ChosenTemplate &chosen,
    const std::optional<CertificateIssue> &issue, const std::vector<FigureMaker> &moreFigures)
    : d(std::make_unique<Private>(results, recipe, createdUtc, chosen, issue))
{
    d->makers.insert(d->makers.end(), moreFigures.begin(), moreFigures.end());
    d->plots = parts == ReportParts::CertificateAndPlots;
    if (!qobject_cast<QApplication *>(QCoreApplication::instance()))
        d->problem = nothingToDrawOn();
}

ReportDrawing::~ReportDrawing() = default;

bool ReportDrawing::isDone() const
{
    return d->isDone();
}

double ReportDrawing::fraction() const
{
    const double share = static_cast<double>(d->steps) / static_cast<double>(d->stepCount());
    return std::min(share, 1.0);
}

void ReportDrawing::draw(std::chrono::milliseconds budget)
{
    if (isDone())
        return;
    QElapsedTimer used;
    used.start();
    const ReproducibleOutput reproducible(d->language.numbers());
    const ReportLanguage::Scope language(d->language);
    do
        d->step();
    while (!isDone() && used.elapsed() < budget.count());
}

Result<std::vector<DrawnFile>> ReportDrawing::take()
{
    if (d->problem)
        return tl::unexpected<Error>(*d->problem);
    d->addDcc();
    return std::move(d->drawn);
}

} // namespace dyncal
