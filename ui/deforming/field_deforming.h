#pragma once

#include "core/deformation/field_fit.h"
#include "core/model/field_file.h"
#include "core/session/region.h"
#include "ui/deforming/deform_stage.h"
#include "ui/deforming/field_arrows.h"
#include "ui/frame/workbench.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

class FieldPage;

/// A deformation by the displacements of another program, from the file to the finished parts: what its page says, what the view shows of
/// it. Window thread.
class FieldDeforming final : public QObject {
    Q_OBJECT
public:
    FieldDeforming(const Workbench& bench, DeformStage& stage, FieldPage& page);

    /// Reads a file in the background and begins with it. A failure is shown in a sentence and leaves everything as it was.
    void open(const QString& path);
    bool hasField() const { return m_field != nullptr; }
    void forget();
    void apply();

signals:
    void opened();                         ///< there is a field to deform with
    void refused(const QString& sentence); ///< why it cannot be done so; empty: it can

private:
    void read(const std::string& path, const FieldChoice& choice);
    void readAnew(const FieldChoice& choice);
    void take(FieldFile file, bool isInPlace);
    void chooseKept(bool on);
    void keepSelected();
    void keepNothing();
    void look();
    void lookAnew();
    std::function<void(const SmoothMap&, TaskControl&)> examiner();
    void showFit(const FieldFit& fit);
    void showSeen(const DeformedFrame& seen);
    void sayFold();
    QStringList warnings() const;
    FieldDeformation deformation() const;
    std::vector<RecipeDeformation> toldInRecipe() const;

    Workbench m_bench;
    DeformStage& m_stage;
    FieldPage& m_page;
    FieldArrows m_arrows;
    FieldFile m_file;                                               ///< without its field
    FieldChoice m_choice;                                           ///< that was read of it
    QString m_reading;                                              ///< title of the task that does it; empty: none
    std::shared_ptr<const DisplacementField> m_field;               ///< null: none
    TriangleMesh m_kept;                                            ///< faces that stay [m]
    Region m_keptFaces;                                             ///< the same by their numbers
    std::shared_ptr<const std::vector<Deformation>> m_deformations; ///< what is looked at
    std::optional<Vec3> m_seenFold; ///< where what is seen turns material inside out [m]
    std::optional<Vec3> m_mapFold;  ///< where the map does at the surfaces [m]
};

} // namespace knead
