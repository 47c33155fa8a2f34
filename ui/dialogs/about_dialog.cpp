#include "ui/dialogs/about_dialog.h"

#include "ui/theme.h"

#include <vtkVersion.h>

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace knead {

namespace {

enum Column { NameColumn, VersionColumn, LicenseColumn };

std::vector<Services::Library> withOwn(std::vector<Services::Library> libraries)
{
    libraries.insert(libraries.begin(), std::initializer_list<Services::Library>{
                                            {"Qt", qVersion(), "LGPL 3"}, {"VTK", vtkVersion::GetVTKVersion(), "BSD"}});
    return libraries;
}

} // namespace

AboutDialog::AboutDialog(const std::vector<Services::Library>& libraries, QWidget* parent)
    : QDialog(parent)
    , m_libraries(withOwn(libraries))
{
    setObjectName("aboutBox");
    setWindowTitle(tr("About Knead"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 20, 20, 14);
    column->setSpacing(12);
    column->addWidget(makeHead());
    column->addWidget(makeList(), 1);
    auto* row = new QHBoxLayout;
    auto* copyButton = new QPushButton(tr("Copy versions"), this);
    copyButton->setObjectName("aboutCopy");
    copyButton->setToolTip(tr("For a report of something that went wrong"));
    auto* close = new QPushButton(tr("Close"), this);
    setRole(*close, "primary");
    close->setDefault(true);
    row->addWidget(copyButton);
    row->addStretch();
    row->addWidget(close);
    column->addLayout(row);
    connect(copyButton, &QPushButton::clicked, this, &AboutDialog::copy);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    resize(withText(580), withText(520));
}

QWidget* AboutDialog::makeHead()
{
    auto* head = new QWidget(this);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    auto* sign = new QLabel(head);
    sign->setPixmap(icon("knead").pixmap(QSize(64, 64), devicePixelRatioF()));
    auto* text = new QLabel(
        tr("<b style='font-size:16pt'>Knead %1</b><br>A CAD workbench in which a part is a lump of real material.")
                .arg(QApplication::applicationVersion()) +
            "<br>" +
            tr("After Jansson, Horváth and Vergeest, <i>Implementation and analysis of a mechanics simulation module "
               "for use in a "
               "conceptual design system</i>, 2000."),
        head);
    text->setObjectName("aboutText");
    text->setTextFormat(Qt::RichText);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    row->addWidget(sign, 0, Qt::AlignTop);
    row->addWidget(text, 1);
    return head;
}

QWidget* AboutDialog::makeList()
{
    auto* list = new QTreeWidget(this);
    list->setObjectName("aboutLibraries");
    list->setProperty("role", "framed");
    list->setRootIsDecorated(false);
    list->setSelectionMode(QAbstractItemView::NoSelection);
    list->setFocusPolicy(Qt::TabFocus);
    list->setColumnCount(3);
    list->setHeaderLabels({tr("Made with"), tr("Version"), tr("License")});
    for (const Services::Library& library : m_libraries)
        new QTreeWidgetItem(list, {QString::fromStdString(library.name), QString::fromStdString(library.version),
                                   QString::fromStdString(library.license)});
    list->header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    list->header()->setSectionResizeMode(VersionColumn, QHeaderView::ResizeToContents);
    list->header()->setSectionResizeMode(LicenseColumn, QHeaderView::ResizeToContents);
    list->header()->setStretchLastSection(false);
    return list;
}

void AboutDialog::copy() const
{
    QStringList lines{"Knead " + QApplication::applicationVersion()};
    for (const Services::Library& library : m_libraries)
        lines << QString::fromStdString(library.name + ' ' + library.version);
    QApplication::clipboard()->setText(lines.join('\n'));
}

} // namespace knead
