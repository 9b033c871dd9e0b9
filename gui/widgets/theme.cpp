// SPDX-License-Identifier: MIT
#include "gui/widgets/theme.hpp"

#include <QApplication>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QPointer>
#include <QPolygonF>
#include <QProxyStyle>
#include <QStyleOption>
#include <QTemporaryDir>

#include <algorithm>
#include <utility>

namespace planum::gui {

namespace {

Theme light() {
    Theme t;
    t.kind = ThemeKind::Light;
    t.window = QColor::fromRgb(0xf3f1ec);
    t.paper = QColor::fromRgb(0xffffff);
    t.ink = QColor::fromRgb(0x1d1c1a);
    t.faint = QColor::fromRgb(0x65615a);
    t.off = QColor::fromRgb(0x9a958b);
    t.edge = QColor::fromRgb(0xd5d0c5);
    t.accent = QColor::fromRgb(0x14627e);
    t.on_accent = QColor::fromRgb(0xffffff);
    t.error = QColor::fromRgb(0xb3101d);
    t.warning = QColor::fromRgb(0x8a5a00);
    t.remark = QColor::fromRgb(0x4d5d73);
    return t;
}

Theme dark() {
    Theme t;
    t.kind = ThemeKind::Dark;
    t.window = QColor::fromRgb(0x26272a);
    t.paper = QColor::fromRgb(0x1b1c1f);
    t.ink = QColor::fromRgb(0xe9e6df);
    t.faint = QColor::fromRgb(0xa8a49b);
    t.off = QColor::fromRgb(0x76736c);
    t.edge = QColor::fromRgb(0x43454a);
    t.accent = QColor::fromRgb(0x5fb8d6);
    t.on_accent = QColor::fromRgb(0x0e1a1f);
    t.error = QColor::fromRgb(0xff7b76);
    t.warning = QColor::fromRgb(0xe9b44c);
    t.remark = QColor::fromRgb(0x9fb0c8);
    return t;
}

Theme sunlight() {
    Theme t;
    t.kind = ThemeKind::Sunlight;
    t.window = QColor::fromRgb(0xffffff);
    t.paper = QColor::fromRgb(0xffffff);
    t.ink = QColor::fromRgb(0x000000);
    t.faint = QColor::fromRgb(0x000000);
    t.off = QColor::fromRgb(0x707070);
    t.edge = QColor::fromRgb(0x000000);
    t.accent = QColor::fromRgb(0x003a8c);
    t.on_accent = QColor::fromRgb(0xffffff);
    t.error = QColor::fromRgb(0xa00000);
    t.warning = QColor::fromRgb(0x6a3d00);
    t.remark = QColor::fromRgb(0x00304f);
    t.text_points = 12.5;
    t.touch = 44;
    return t;
}

Theme& current() {
    static Theme one = light();
    return one;
}

QPalette palette_of(const Theme& t) {
    QPalette p;
    p.setColor(QPalette::Window, t.window);
    p.setColor(QPalette::WindowText, t.ink);
    p.setColor(QPalette::Base, t.paper);
    p.setColor(QPalette::AlternateBase, t.window);
    p.setColor(QPalette::Text, t.ink);
    p.setColor(QPalette::PlaceholderText, t.faint);
    p.setColor(QPalette::Button, t.window);
    p.setColor(QPalette::ButtonText, t.ink);
    p.setColor(QPalette::ToolTipBase, t.paper);
    p.setColor(QPalette::ToolTipText, t.ink);
    p.setColor(QPalette::Highlight, t.accent);
    p.setColor(QPalette::HighlightedText, t.on_accent);
    p.setColor(QPalette::Link, t.accent);
    p.setColor(QPalette::Mid, t.edge);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        p.setColor(QPalette::Disabled, role, t.off);
    }
    return p;
}

// Style sheets take arrows and ticks from files only.
QString sign_file(const char* name, const QColor& ink, const QPolygonF& line) {
    static const QTemporaryDir folder;
    const QString file = folder.filePath(QLatin1String(name) + ink.name().mid(1) + QStringLiteral(".png"));
    QImage image(40, 40, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 6.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.end();
    image.save(file);
    return file;
}

QString arrow_file(const QColor& ink) {
    return sign_file("arrow", ink, QPolygonF({QPointF(6.0, 14.0), QPointF(20.0, 28.0), QPointF(34.0, 14.0)}));
}

QString tick_file(const QColor& ink) {
    return sign_file("tick", ink, QPolygonF({QPointF(8.0, 21.0), QPointF(17.0, 30.0), QPointF(33.0, 10.0)}));
}

// What a finger meets on a tablet: everything that is pressed is as high as Theme::touch. Scroll bars are as wide as a
// finger can drag, and the arrows at their ends, which none can hit, are left out.
QString touch_sheet() {
    return QStringLiteral(R"(
QToolBar { padding: 1px 8px; }
QTabBar::tab { min-height: %tabpx; padding: 0 12px; }
QMenuBar::item { padding: 8px 9px; }
QMenuBar::item:selected, QMenu::item:selected { background: %accent; color: %on; }
QMenu { background: %paper; color: %ink; border: 1px solid %edge; }
QMenu::item { min-height: %touchpx; padding: 0 26px 0 30px; }
QMenu::item:disabled { color: %off; }
QMenu::separator { height: 1px; background: %edge; }
QCheckBox, QRadioButton { min-height: %touchpx; }
QListView::item, QTreeView::item { min-height: %touchpx; }
QComboBox { combobox-popup: 0; }
QComboBox QAbstractItemView::item { min-height: %touchpx; }
QScrollBar:vertical { width: 26px; background: %window; border-left: 1px solid %edge; }
QScrollBar:horizontal { height: 26px; background: %window; border-top: 1px solid %edge; }
QScrollBar::handle { background: %off; border: 4px solid %window; border-radius: 8px; }
QScrollBar::handle:vertical { min-height: %touchpx; }
QScrollBar::handle:horizontal { min-width: %touchpx; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: none; }
QSplitter::handle:horizontal { width: 12px; }
QSplitter::handle:vertical { height: 12px; }
)");
}

QString sheet_of(const Theme& t) {
    QString sheet = QStringLiteral(R"(
QDockWidget { titlebar-close-icon: none; titlebar-normal-icon: none; }
QToolBar { border: none; border-bottom: 1px solid %edge; spacing: 4px; padding: 4px 8px; background: %window; }
QToolButton, QPushButton { min-height: %buttonpx; padding: 0 10px; border: 1px solid %edge; border-radius: 4px;
  background: %paper; color: %ink; }
QToolButton:hover, QPushButton:hover { border-color: %accent; }
QToolButton:pressed, QPushButton:pressed, QToolButton:checked { background: %accent; color: %on; }
QToolButton:disabled, QPushButton:disabled { color: %off; background: %window; border: 1px dashed %off; }
QToolBar QToolButton { border-color: transparent; background: transparent; }
QToolBar QToolButton:hover { border-color: %edge; background: %paper; }
QToolBar QToolButton:disabled { border-color: transparent; }
QLineEdit, QComboBox, QPlainTextEdit { border: 1px solid %edge; border-radius: 4px; padding: 2px 6px;
  background: %paper; color: %ink; selection-background-color: %accent; selection-color: %on; }
QLineEdit, QComboBox { min-height: %buttonpx; }
QLineEdit:focus, QComboBox:focus, QPlainTextEdit:focus { border: 2px solid %accent; padding: 1px 5px; }
QLineEdit:disabled, QComboBox:disabled, QPlainTextEdit:disabled, QLineEdit:read-only, QPlainTextEdit:read-only {
  color: %readonly; background: %window; border: 1px dashed %off; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(%arrow); width: 10px; height: 10px; }
QTableView, QListView, QTreeView { border: none; background: %paper; gridline-color: transparent; outline: none; }
QHeaderView::section { background: %window; color: %faint; border: none; border-bottom: 1px solid %edge; padding: 5px 8px; }
QTabBar { qproperty-drawBase: 0; }
QTabBar::tab { padding: 7px 16px; background: transparent; color: %faint; border: none; border-bottom: 3px solid transparent; }
QTabBar::tab:selected { color: %ink; border-bottom: 3px solid %accent; }
QTabWidget::pane { border: none; border-top: 1px solid %edge; }
QStatusBar { border-top: 1px solid %edge; background: %window; color: %faint; }
QStatusBar::item { border: none; }
QStatusBar QLabel { padding: 0 8px; }
QToolTip { border: 1px solid %edge; background: %paper; color: %ink; padding: 4px; }
QScrollArea, QScrollArea > QWidget { border: none; background: %paper; }
#card { background: %paper; }
QCheckBox::indicator { width: %checkpx; height: %checkpx; border: 1px solid %faint; border-radius: 3px; background: %paper; }
QCheckBox::indicator:checked { background: %accent; border-color: %accent; image: url(%tick); }
QCheckBox::indicator:disabled { border: 1px dashed %off; }
QLabel[role="heading"] { font-weight: 600; color: %faint; }
QLabel[role="title"] { font-size: %titlept; font-weight: 600; }
QLabel[role="faint"] { color: %faint; }
QLabel[role="error"] { color: %error; }
QLabel[role="warning"] { color: %warning; }
QFrame[role="notice"] { background: %paper; border: 1px solid %error; border-left: 5px solid %error; border-radius: 4px; }
QFrame[role="line"] { background: %edge; max-height: 1px; min-height: 1px; border: none; }
)");
    if (t.kind == ThemeKind::Sunlight) sheet += touch_sheet();
    const auto put = [&](const char* key, const QString& value) { sheet.replace(QLatin1String(key), value); };
    put("%titlept", QString::number(t.text_points * 1.3) + QStringLiteral("pt"));
    // With their edges they are as high as what is pressed should be, which on a desk may be less.
    const int edges = t.kind == ThemeKind::Sunlight ? 2 : 8;
    put("%buttonpx", QString::number(t.touch - edges) + QStringLiteral("px"));
    put("%touchpx", QString::number(t.touch) + QStringLiteral("px"));
    put("%tabpx", QString::number(t.touch - 3) + QStringLiteral("px"));
    put("%checkpx", QString::number(t.touch / 2 - 1) + QStringLiteral("px"));
    put("%arrow", arrow_file(t.faint));
    put("%tick", tick_file(t.on_accent));
    put("%on", t.on_accent.name());
    put("%readonly", t.ink.name());
    put("%off", t.off.name());
    put("%window", t.window.name());
    put("%paper", t.paper.name());
    put("%ink", t.ink.name());
    put("%faint", t.faint.name());
    put("%edge", t.edge.name());
    put("%accent", t.accent.name());
    put("%error", t.error.name());
    put("%warning", t.warning.name());
    return sheet;
}

// What of the window itself is drawn by no style sheet (see StyledParts).
class WindowStyle : public QProxyStyle {
  public:
    WindowStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        switch (metric) {
        case PM_DockWidgetSeparatorExtent: return 1;
        case PM_DockWidgetTitleMargin: return 6;
        default: return QProxyStyle::pixelMetric(metric, option, widget);
        }
    }

    // A dock would write its title in the font that it was made with, whatever the theme is now.
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        const auto* title = qstyleoption_cast<const QStyleOptionDockWidget*>(option);
        if (element != CE_DockWidgetTitle || title == nullptr || widget == nullptr)
            return QProxyStyle::drawControl(element, option, painter, widget);
        constexpr int kSide = 14;
        const QRect room = option->rect.adjusted(kSide, 0, -kSide, 0);
        painter->save();
        painter->fillRect(option->rect, theme().window);
        painter->setFont(widget->font());
        drawItemText(painter, room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextShowMnemonic, title->palette, true,
                     widget->fontMetrics().elidedText(title->title, Qt::ElideRight, room.width()),
                     QPalette::WindowText);
        painter->restore();
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        if (element != PE_IndicatorDockWidgetResizeHandle)
            return QProxyStyle::drawPrimitive(element, option, painter, widget);
        painter->fillRect(option->rect, theme().edge);
    }
};

} // namespace

QColor Theme::drawn(std::uint32_t rgb) const {
    const QColor colour = QColor::fromRgb(rgb);
    if (kind == ThemeKind::Light) return colour;
    float h = 0.0F;
    float s = 0.0F;
    float l = 0.0F;
    colour.getHslF(&h, &s, &l);
    if (kind == ThemeKind::Dark) return QColor::fromHslF(std::max(h, 0.0F), s * 0.9F, 0.92F - 0.81F * l);
    if (s > 0.4F) return colour.darker(120); // a meaning: keep it
    return l < 0.75F ? ink : paper;
}

const Theme& theme() noexcept { return current(); }

void apply_theme(ThemeKind kind, StyledParts::Pace pace) {
    current() = kind == ThemeKind::Light ? light() : kind == ThemeKind::Dark ? dark() : sunlight();
    // Each of these goes through all widgets, and the window waits for it: only what changes is set, and the style
    // once.
    static bool has_style = false;
    if (!std::exchange(has_style, true)) QApplication::setStyle(new WindowStyle);
    QApplication::setPalette(palette_of(theme()));
    QFont font = QApplication::font();
    if (font.pointSizeF() != theme().text_points) {
        font.setPointSizeF(theme().text_points);
        QApplication::setFont(font);
    }
    static const QPointer<StyledParts> parts = new StyledParts(qApp);
    parts->set_sheet(sheet_of(theme()), pace);
}

QString to_word(ThemeKind kind) {
    switch (kind) {
    case ThemeKind::Light: return QStringLiteral("light");
    case ThemeKind::Dark: return QStringLiteral("dark");
    case ThemeKind::Sunlight: return QStringLiteral("sunlight");
    }
    return {};
}

ThemeKind theme_from_word(const QString& word) noexcept {
    if (word == QLatin1String("dark")) return ThemeKind::Dark;
    if (word == QLatin1String("sunlight")) return ThemeKind::Sunlight;
    return ThemeKind::Light;
}

} // namespace planum::gui
