// SPDX-License-Identifier: MIT
#include "gui/widgets/window/start_page.hpp"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/widgets/window/main_window.hpp"
#include "gui/widgets/window/project_menu.hpp"

namespace planum::gui {

namespace {

constexpr int kWidth = 420; // [px] of the column: buttons as wide as the window would be no buttons
constexpr qsizetype kMostShown = 6;

QLabel* faint(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("role", "faint");
    label->setWordWrap(true);
    return label;
}

} // namespace

StartPage::StartPage(MainWindow& window) : window_(window), recent_(new QVBoxLayout) {
    setObjectName(QStringLiteral("startPage"));
    auto* inside = new QWidget;
    inside->setFixedWidth(kWidth);
    auto* column = new QVBoxLayout(inside);
    column->setSpacing(10);
    auto* title = new QLabel(tr("No project is open"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 1.6);
    title->setFont(large);
    column->addWidget(title);
    const auto button = [&](const char* action, const QString& text, const QString& meaning) {
        auto* made = new QPushButton(text);
        made->setObjectName(QStringLiteral("start_") + QString::fromLatin1(action));
        made->setAccessibleDescription(meaning);
        connect(made, &QPushButton::clicked, this, [this, name = QString::fromLatin1(action)] {
            if (auto* found = window_.findChild<QAction*>(name)) found->trigger();
        });
        column->addWidget(made);
        column->addWidget(faint(meaning));
    };
    button("newProject", tr("New project …"),
           tr("One file for the whole dig; lists, scans and outlines come into it."));
    button("openProject", tr("Open …"), tr("Or drop a project on the window."));
    button("makeDemo", tr("Make a sample dig …"),
           tr("To try everything out: sheets, scans and a few mistakes to find."));
    column->addSpacing(8);
    column->addLayout(recent_);
    // Stretches instead of an alignment: only so do lines that are broken get their height.
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(inside);
    row->addStretch(1);
    auto* whole = new QWidget;
    auto* middle = new QVBoxLayout(whole);
    middle->addStretch(2);
    middle->addLayout(row);
    middle->addStretch(3);
    // What does not fit on a low screen is scrolled to: it must not make the window higher than that.
    auto* scrolled = new QScrollArea;
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setWidgetResizable(true);
    scrolled->setWidget(whole);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scrolled);
}

void StartPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    fill_recent();
}

void StartPage::fill_recent() {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const QStringList files = ProjectMenu::recent().mid(0, kMostShown);
    if (files.isEmpty()) return;
    recent_->addWidget(faint(tr("Opened lately")));
    for (const QString& file : files) {
        auto* open = new QToolButton;
        const QFileInfo info(file);
        open->setText(QStringLiteral("%1   –   %2").arg(info.completeBaseName(), info.dir().dirName()));
        open->setToolTip(file);
        open->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(open, &QToolButton::clicked, this,
                [this, file] { window_.open(file.toStdString(), store::OpenMode::ReadWrite); });
        recent_->addWidget(open);
    }
}

} // namespace planum::gui
