// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

namespace dyncal {

class Banner;
class CaptureImport;
class Prompts;
class Session;
enum class BannerAction;

/// Says above every page that a file of the recordings is no longer as it was when it was opened,
/// and offers to read it again or to look for it elsewhere.
class SourceNotice : public QObject
{
    Q_OBJECT

public:
    SourceNotice(Session &session, CaptureImport &captures, Prompts &prompts, Banner &banner,
        QObject *parent);

    void showWords(); ///< in the language of the moment

private:
    void show();
    void obey(BannerAction action);

    Session &m_session;
    CaptureImport &m_captures;
    Prompts &m_prompts;
    Banner &m_banner;
};

} // namespace dyncal
