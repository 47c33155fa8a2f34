#include "ui/theme.h"

#include <QApplication>
#include <QFile>
#include <QFont>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QSvgRenderer>
#include <QWidget>

#include <algorithm>
#include <utility>

// The resources of a static library are not found by themselves; the macro must stand outside of namespaces.
static void initializeResources()
{
    Q_INIT_RESOURCE(knead);
}

namespace knead {

namespace {

/// Draws an SVG whose lines are "currentColor" in the color of the text around it, so that it follows the theme.
class SvgIconEngine final : public QIconEngine {
public:
    explicit SvgIconEngine(QByteArray source)
        : m_source(std::move(source))
    {
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State /*state*/) override
    {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
        QByteArray source = m_source;
        source.replace("currentColor", QApplication::palette().color(group, role).name().toLatin1());
        QSvgRenderer(source).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new SvgIconEngine(*this); }

private:
    QByteArray m_source;
};

/// Fusion with check boxes and radio buttons that are seen on dark ground, too: Fusion draws their rims darker than the window.
/// The buttons of panels are ours: those of Qt are ten pixels wide, and blurred on a screen of fine pixels.
class Style final : public QProxyStyle {
public:
    Style()
        : QProxyStyle(QStyleFactory::create("Fusion"))
    {
    }

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override
    {
        switch (element) {
        case PE_IndicatorCheckBox:
        case PE_IndicatorItemViewItemCheck:
        case PE_IndicatorRadioButton:
            drawIndicator(*option, *painter, element == PE_IndicatorRadioButton);
            break;
        default:
            QProxyStyle::drawPrimitive(element, option, painter, widget);
        }
    }

    QIcon standardIcon(StandardPixmap standard, const QStyleOption* option, const QWidget* widget) const override
    {
        switch (standard) {
        case SP_TitleBarCloseButton:
            return icon("close");
        case SP_TitleBarNormalButton:
            return icon("float");
        default:
            return QProxyStyle::standardIcon(standard, option, widget);
        }
    }

private:
    static void drawIndicator(const QStyleOption& option, QPainter& painter, bool isRound)
    {
        const QPalette& colors = option.palette;
        const bool isAble = option.state.testFlag(State_Enabled);
        const bool isSet = option.state.testFlag(State_On) || option.state.testFlag(State_NoChange);
        const bool isLit = isAble && (option.state.testFlag(State_MouseOver) || option.state.testFlag(State_HasFocus));
        const QColor ink = colors.color(isAble ? QPalette::Active : QPalette::Disabled, QPalette::Text);
        const qreal side = std::min(option.rect.width(), option.rect.height()) - 1.5;
        QRectF box(0, 0, side, side);
        box.moveCenter(QRectF(option.rect).center());
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        const QColor accent = colors.color(QPalette::Highlight);
        const QColor rim = isAble ? colors.color(QPalette::PlaceholderText) : colors.color(QPalette::Mid);
        painter.setPen(QPen(isLit || (isSet && isAble) ? accent : rim, 1.2));
        painter.setBrush(isSet && isAble ? accent : colors.color(QPalette::Base));
        const qreal roundness = isRound ? side / 2 : 3;
        painter.drawRoundedRect(box, roundness, roundness);
        if (isSet)
            drawMark(painter, box, isAble ? colors.color(QPalette::HighlightedText) : ink, isRound,
                     option.state.testFlag(State_NoChange));
        painter.restore();
    }

    static void drawMark(QPainter& painter, const QRectF& box, const QColor& color, bool isRound, bool isPartial)
    {
        if (isRound) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(color);
            painter.drawEllipse(box.center(), box.width() / 4.5, box.width() / 4.5);
            return;
        }
        const auto at = [&box](qreal x, qreal y) { return box.topLeft() + QPointF(x * box.width(), y * box.height()); };
        QPainterPath mark(isPartial ? at(0.25, 0.5) : at(0.22, 0.52));
        if (!isPartial)
            mark.lineTo(at(0.42, 0.72));
        mark.lineTo(isPartial ? at(0.75, 0.5) : at(0.78, 0.30));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(mark);
    }
};

struct ThemeColors {
    QColor window, base, alternate, button, text, dimmed, disabled, line, accent, accentText, link, tint, problem, tip;
};

int textSize = 100; // [per cent of what the system asks for]

ThemeColors colorsOf(Theme theme)
{
    if (theme == Theme::Dark)
        return {.window = "#2a2d31",
                .base = "#1f2225",
                .alternate = "#25282c",
                .button = "#363a40",
                .text = "#e6e8ea",
                .dimmed = "#b0b6bd",
                .disabled = "#858b92",
                .line = "#454a51",
                .accent = "#2c70dc",
                .accentText = "#ffffff",
                .link = "#8ab5f9",
                .tint = "#28456e",
                .problem = "#ff8585",
                .tip = "#3a3f45"};
    return {.window = "#f0f2f4",
            .base = "#ffffff",
            .alternate = "#f6f7f9",
            .button = "#e9ecef",
            .text = "#1d2126",
            .dimmed = "#5d656e",
            .disabled = "#80868d",
            .line = "#c9ced4",
            .accent = "#1668dc",
            .accentText = "#ffffff",
            .link = "#1562d2",
            .tint = "#d3e3fb",
            .problem = "#c9222d",
            .tip = "#ffffff"};
}

QPalette paletteOf(const ThemeColors& colors)
{
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, const QColor& color) { palette.setColor(role, color); };
    set(QPalette::Window, colors.window);
    set(QPalette::WindowText, colors.text);
    set(QPalette::Base, colors.base);
    set(QPalette::AlternateBase, colors.alternate);
    set(QPalette::Text, colors.text);
    set(QPalette::PlaceholderText, colors.dimmed);
    set(QPalette::Button, colors.button);
    set(QPalette::ButtonText, colors.text);
    set(QPalette::BrightText, colors.problem);
    set(QPalette::ToolTipBase, colors.tip);
    set(QPalette::ToolTipText, colors.text);
    set(QPalette::Highlight, colors.accent);
    set(QPalette::HighlightedText, colors.accentText);
    set(QPalette::Link, colors.link);
    set(QPalette::Mid, colors.line);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, colors.disabled);
    return palette;
}

/// What the palette cannot say. Colors are filled in by name.
QString styleSheet(const ThemeColors& colors)
{
    QString sheet = QStringLiteral(R"(
QMainWindow::separator { background: @line; width: 1px; height: 1px; }
QToolBar { border: none; border-bottom: 1px solid @line; padding: 3px 6px; spacing: 2px; }
QToolBar QToolButton { padding: 4px 7px; border: 1px solid transparent; border-radius: 5px; }
QToolBar QToolButton:hover { background: @button; border-color: @line; }
QToolBar QToolButton:checked { background: @tint; border-color: @accent; }
QToolBar QToolButton:focus { border-color: @accent; }
QToolButton:checked { background: @tint; border: 1px solid @accent; border-radius: 5px; }
QToolButton:focus { border: 1px solid @accent; border-radius: 5px; }
QToolButton:checked:focus, QToolBar QToolButton:checked:focus { border-color: @text; }
QToolBar QToolButton:checked:disabled { background: transparent; border-color: @line; }
QToolBar QToolButton[popupMode="InstantPopup"] { padding-right: 12px; }
QToolBar QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: right center; right: 1px; }
QToolBar::separator { background: @line; }
QToolBar::separator:horizontal { width: 1px; margin: 5px 2px; }
QToolBar::separator:vertical { height: 1px; margin: 2px 5px; }
QTabBar::tab { padding: 3px 8px; border: none; background: transparent; color: @dimmed; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected:focus { background: @tint; }
QTabBar::tab:selected { background: @base; color: @text; }
QTabBar::tab:bottom { border-bottom: 2px solid transparent; }
QTabBar::tab:bottom:selected { border-bottom-color: @accent; }
QTabBar::tab:top { border-top: 2px solid transparent; }
QTabBar::tab:top:selected { border-top-color: @accent; }
QDockWidget { font-weight: 600; }
QDockWidget::title { padding: 3px 8px; background: @window; border-bottom: 1px solid @line; }
QTreeView, QPlainTextEdit { border: 1px solid transparent; background: @base; }
QTextEdit { border: 1px solid transparent; }
QTreeView:focus, QPlainTextEdit:focus, QTextEdit:focus { border-color: @accent; }
QTreeView::item { padding: 3px 2px; }
QLineEdit { padding: 3px 6px; min-height: 18px; border: 1px solid @line; border-radius: 4px; background: @base; }
QLineEdit:focus { border-color: @accent; }
QLineEdit:disabled { color: @disabled; background: @window; }
QLineEdit[problem="true"] { border: 1px solid @problem; color: @problem; }
QComboBox, QSpinBox { min-height: 22px; }
QPushButton { padding: 5px 12px; border: 1px solid @line; border-radius: 5px; background: @button; }
QPushButton:hover { border-color: @accent; }
QPushButton:focus { border: 2px solid @accent; padding: 4px 11px; }
QPushButton:pressed { background: @line; }
QPushButton:disabled { color: @disabled; }
QPushButton[role="primary"] { background: @accent; color: @accentText; border-color: @accent; font-weight: 600; }
QPushButton[role="primary"]:focus { border-color: @text; }
QPushButton[role="primary"]:disabled { background: @button; color: @disabled; border-color: @line; }
QToolButton[role="primary"] { padding: 7px 18px; border: 1px solid @accent; border-radius: 5px; background: @accent;
    color: @accentText; font-weight: 600; }
QToolButton[role="primary"]:focus { border-color: @text; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QHeaderView::section { padding: 4px 3px; border: none; border-bottom: 1px solid @line; background: @window; }
QListWidget { border: 1px solid @line; border-radius: 6px; background: @base; outline: none; }
QListWidget:focus { border-color: @accent; }
QListWidget::item { padding: 7px 8px; border-radius: 4px; }
QListWidget::item:selected { background: @accent; color: @accentText; }
QStatusBar { border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QProgressBar { border: 1px solid @line; border-radius: 4px; background: @base; text-align: center; max-height: 16px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QLabel[role="dimmed"] { color: @dimmed; }
QLabel[role="heading"] { font-weight: 600; }
QLabel[role="slow"] { color: @problem; font-weight: 600; }
QLabel[role="big"] { font-size: @bigText; font-weight: 600; }
QLabel[role="force"] {
    background: @tip; color: @text; border: 1px solid @line; border-radius: 4px; padding: 2px 6px; font-weight: 600;
}
QFrame#banner { background: @tip; border: 1px solid @line; border-bottom: 2px solid @problem; border-radius: 4px; }
QFrame#dropZone { border: 2px dashed @line; border-radius: 12px; background: @base; }
QFrame#dropZone[isOver="true"] { border-color: @accent; background: @tint; }
QFrame#trial { border: 2px solid @accent; border-radius: 12px; background: @base; }
QFrame#waitingWork { border: 1px solid @line; border-left: 4px solid @accent; border-radius: 6px; background: @base; }
QLabel[role="title"] { font-size: @titleText; font-weight: 600; }
QTreeView[role="framed"] { border: 1px solid @line; border-radius: 4px; }
QTreeView[role="framed"]:focus { border-color: @accent; }
QFrame#commandPalette { background: @tip; border: 1px solid @accent; border-radius: 9px; }
QFrame#commandPalette QListWidget { border: none; background: transparent; }
QFrame#tour { background: @tip; border: 1px solid @accent; border-radius: 9px; }
QToolTip { background: @tip; color: @text; border: 1px solid @line; padding: 4px; }
)");
    const std::pair<const char*, QColor> names[] = {
        {"@window", colors.window},     {"@base", colors.base},     {"@button", colors.button},
        {"@text", colors.text},         {"@dimmed", colors.dimmed}, {"@line", colors.line},
        {"@disabled", colors.disabled}, {"@tip", colors.tip},       {"@accentText", colors.accentText},
        {"@accent", colors.accent},     {"@tint", colors.tint},     {"@problem", colors.problem}};
    for (const auto& [name, color] : names)
        sheet.replace(QLatin1String(name), color.name());
    sheet.replace("@bigText", QString::number(withText(16)) + "pt");
    sheet.replace("@titleText", QString::number(withText(12)) + "pt");
    return sheet;
}

} // namespace

int withText(int pixels)
{
    return pixels * textSize / 100;
}

void applyTextSize(int textPercent)
{
    static const QFont systemFont = QApplication::font();
    if (std::exchange(textSize, textPercent) == textPercent)
        return;
    QFont font = systemFont;
    if (font.pointSizeF() > 0)
        font.setPointSizeF(font.pointSizeF() * textPercent / 100);
    else
        font.setPixelSize(font.pixelSize() * textPercent / 100);
    QApplication::setFont(font);
}

void applyTheme(QApplication& application, Theme theme, int textPercent)
{
    initializeResources();
    applyTextSize(textPercent);
    const ThemeColors colors = colorsOf(theme);
    static const bool isStyled = [] { // once: it belongs to the program
        QApplication::setStyle(new Style);
        return true;
    }();
    Q_UNUSED(isStyled);
    const QString sheet = styleSheet(colors);
    if (application.styleSheet() == sheet)
        return; // every widget of every window would be styled anew, which takes half a second
    QApplication::setPalette(paletteOf(colors));
    application.setStyleSheet(sheet);
}

void setRole(QWidget& widget, const char* role)
{
    if (widget.property("role").toString() == role)
        return;
    widget.setProperty("role", role);
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
}

QIcon icon(const QString& name)
{
    initializeResources();
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QFile::ReadOnly))
        qFatal("icon %s is missing", qPrintable(name));
    return QIcon(new SvgIconEngine(file.readAll()));
}

} // namespace knead
