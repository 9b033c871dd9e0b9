// SPDX-License-Identifier: MIT
#include "gui/widgets/window/import_dialog.hpp"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace planum::gui {

ImportDialog::ImportDialog(DayJobs& day, DayJobs::Files files, QWidget* parent)
    : QDialog(parent), day_(day), files_(std::move(files)),
      update_(new QCheckBox(tr("what the files say replaces what differs"))), heading_(new QLabel(tr("reading …"))),
      text_(new QPlainTextEdit), import_(new QPushButton(tr("Import"))) {
    setObjectName(QStringLiteral("importDialog"));
    setWindowTitle(tr("Import"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(760, 520);
    text_->setReadOnly(true);
    text_->setObjectName(QStringLiteral("importPreview"));
    import_->setObjectName(QStringLiteral("importNow"));
    import_->setEnabled(false);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->addButton(import_, QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        day_.import(files_, update_->isChecked());
        accept();
    });
    connect(update_, &QCheckBox::toggled, this, &ImportDialog::look_again);
    connect(&day_, &DayJobs::previewed, this, &ImportDialog::show_preview);
    connect(&day_, &DayJobs::notPreviewed, this, [this](const QString& sentence) {
        heading_->setText(tr("The files cannot be read; nothing was changed."));
        text_->setPlainText(sentence);
    });
    heading_->setObjectName(QStringLiteral("importHeading"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(heading_);
    column->addWidget(text_, 1);
    column->addWidget(update_);
    column->addWidget(buttons);
    look_again();
}

void ImportDialog::look_again() {
    import_->setEnabled(false);
    day_.preview_import(files_, update_->isChecked());
}

void ImportDialog::show_preview(const ImportPreview& preview) {
    heading_->setText(preview.changes ? tr("This is what would change; nothing is written yet.")
                                      : tr("Nothing in the files is new."));
    QStringList all;
    const auto block = [&](const QString& title, const QStringList& lines) {
        if (lines.isEmpty()) return;
        all << QStringLiteral("%1 (%2)").arg(title).arg(lines.size());
        for (const QString& line : lines) all << QStringLiteral("   ") + line;
        all << QString();
    };
    block(tr("New"), preview.fresh);
    block(tr("Differs; the project's is kept unless you say otherwise"), preview.changed);
    block(tr("Not understood, or worth a look"), preview.not_understood);
    text_->setPlainText(all.join(QLatin1Char('\n')));
    import_->setEnabled(preview.changes);
}

} // namespace planum::gui
