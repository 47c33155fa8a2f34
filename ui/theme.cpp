#include "ui/theme.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>
#include <QSvgRenderer>

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

struct ThemeColors {
    QColor window, base, alternate, button, text, dimmed, disabled, line, accent, accentText, tint, problem, tip;
};

ThemeColors colorsOf(Theme theme)
{
    if (theme == Theme::Dark)
        return {.window = "#2a2d31",
                .base = "#1f2225",
                .alternate = "#25282c",
                .button = "#363a40",
                .text = "#e6e8ea",
                .dimmed = "#a3a9b0",
                .disabled = "#6d737a",
                .line = "#454a51",
                .accent = "#3d8bfd",
                .accentText = "#ffffff",
                .tint = "#28456e",
                .problem = "#ff6b6b",
                .tip = "#3a3f45"};
    return {.window = "#f0f2f4",
            .base = "#ffffff",
            .alternate = "#f6f7f9",
            .button = "#e9ecef",
            .text = "#1d2126",
            .dimmed = "#5d656e",
            .disabled = "#a0a7ae",
            .line = "#c9ced4",
            .accent = "#1668dc",
            .accentText = "#ffffff",
            .tint = "#d3e3fb",
            .problem = "#cf2530",
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
    set(QPalette::Link, colors.accent);
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
QToolBar QToolButton:checked:disabled { background: transparent; border-color: @line; }
QDockWidget { font-weight: 600; }
QDockWidget::title { padding: 3px 8px; background: @window; border-bottom: 1px solid @line; }
QTreeView, QPlainTextEdit { border: none; background: @base; }
QTreeView::item { padding: 3px 2px; }
QLineEdit { padding: 3px 6px; min-height: 18px; border: 1px solid @line; border-radius: 4px; background: @base; }
QLineEdit:focus { border-color: @accent; }
QLineEdit:disabled { color: @disabled; background: @window; }
QLineEdit[problem="true"] { border: 1px solid @problem; color: @problem; }
QComboBox { min-height: 22px; }
QPushButton { padding: 5px 12px; border: 1px solid @line; border-radius: 5px; background: @button; }
QPushButton:hover { border-color: @accent; }
QPushButton:pressed { background: @line; }
QPushButton:disabled { color: @disabled; }
QPushButton[role="primary"] { background: @accent; color: @accentText; border-color: @accent; font-weight: 600; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QListWidget { border: 1px solid @line; border-radius: 6px; background: @base; outline: none; }
QListWidget::item { padding: 7px 8px; border-radius: 4px; }
QListWidget::item:selected { background: @accent; color: @accentText; }
QStatusBar { border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QProgressBar { border: 1px solid @line; border-radius: 4px; background: @base; text-align: center; max-height: 16px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QLabel[role="dimmed"] { color: @dimmed; }
QLabel[role="heading"] { font-weight: 600; }
QLabel[role="slow"] { color: @problem; font-weight: 600; }
QLabel[role="big"] { font-size: 16pt; font-weight: 600; }
QLabel[role="force"] {
    background: @tip; color: @text; border: 1px solid @line; border-radius: 4px; padding: 2px 6px; font-weight: 600;
}
QFrame#banner { background: @tip; border: none; border-bottom: 2px solid @problem; }
QFrame#dropZone { border: 2px dashed @line; border-radius: 12px; background: @base; }
QToolTip { background: @tip; color: @text; border: 1px solid @line; padding: 4px; }
)");
    const std::pair<const char*, QColor> names[] = {
        {"@window", colors.window},     {"@base", colors.base},     {"@button", colors.button},
        {"@text", colors.text},         {"@dimmed", colors.dimmed}, {"@line", colors.line},
        {"@disabled", colors.disabled}, {"@tip", colors.tip},       {"@accentText", colors.accentText},
        {"@accent", colors.accent},     {"@tint", colors.tint},     {"@problem", colors.problem}};
    for (const auto& [name, color] : names)
        sheet.replace(QLatin1String(name), color.name());
    return sheet;
}

} // namespace

void applyTheme(QApplication& application, Theme theme)
{
    initializeResources();
    const ThemeColors colors = colorsOf(theme);
    if (application.style()->objectName().compare("fusion", Qt::CaseInsensitive) != 0)
        QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(paletteOf(colors));
    application.setStyleSheet(styleSheet(colors));
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
