// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_output.h"

#include "ui/plot/plot_export.h"
#include "ui/report/certificate_pdf.h"
#include "ui/report/certificate_sources.h"
#include "ui/report/report_figures.h"
#include "ui/report/report_language.h"
#include "ui/report/reproducible_output.h"

#include <QApplication>
#include <QDir>
#include <QSaveFile>

namespace dyncal {

namespace {

constexpr QSize kPlotSize(900, 480);

tl::unexpected<Error> cannotWrite(const QString &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The file %1 cannot be written; choose a folder that exists and can be written."),
            {path.toStdString()}});
}

bool writeFile(const QString &path, const QByteArray &bytes)
{
    QSaveFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
}

} // namespace

Result<std::vector<std::string>> writeReport(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const std::string &directory)
{
    if (!qobject_cast<QApplication *>(QCoreApplication::instance()))
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core", "The report was asked for before the program was set up to draw."),
                {}});
    const QDir folder(QString::fromStdString(directory));
    if (!folder.mkpath(QStringLiteral("plots")))
        return cannotWrite(folder.filePath(QStringLiteral("plots")));

    const ReproducibleOutput reproducible;
    const CertificateData data = makeCertificate(certificateSources(results, recipe, createdUtc));
    const ReportLanguage language(data.language);
    const std::vector<ReportFigure> figures = reportFigures(results);
    const QByteArray pdf = certificatePdf(data, figures);
    const QString certificate = QStringLiteral("certificate.pdf");
    if (pdf.isEmpty() || !writeFile(folder.filePath(certificate), pdf))
        return cannotWrite(folder.filePath(certificate));
    std::vector<std::string> written{folder.filePath(certificate).toStdString()};

    for (std::size_t i = 0; i < figures.size(); ++i) {
        const QString name = QStringLiteral("plots/%1-%2.svg")
                                 .arg(i + 1, 2, 10, QLatin1Char('0'))
                                 .arg(QString::fromStdString(figures[i].id));
        const PlotPicture picture{
            std::make_shared<const PlotContent>(figures[i].content), {}, {}, {}};
        if (!savePicture(picture, kPlotSize, folder.filePath(name)))
            return cannotWrite(folder.filePath(name));
    }
    if (!figures.empty())
        written.push_back(folder.filePath(QStringLiteral("plots/")).toStdString());
    return written;
}

} // namespace dyncal
