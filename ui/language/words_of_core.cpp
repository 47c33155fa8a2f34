// Words that core and tables bring into the window, marked for the translators.
#include <QtGlobal>

namespace knead {

namespace {

[[maybe_unused]] const char* const materialWords[] = {QT_TRANSLATE_NOOP("MaterialPanel", "Elastic"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Flow"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Strength"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Surface"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Density"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Young's modulus"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Poisson's ratio"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Damping ratio"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Shape damping"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Friction"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Yield stress"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "never yields"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Hardening"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Relaxation time"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "flows at once"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Tensile strength"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "never breaks"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Elongation at break"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "no limit"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Toughness"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "knives do not cut it"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Adhesion"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "does not stick"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Healing time"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "does not heal"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Rubber"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Rubberlike"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "for small strains"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Second-invariant share"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "Locking elongation"),
                                                      QT_TRANSLATE_NOOP("MaterialPanel", "never locks")};

/// Those that come with the program.
[[maybe_unused]] const char* const namesOfMaterials[] = {QT_TRANSLATE_NOOP("MaterialName", "Soft jelly"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Jelly"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Soft foam"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Sponge rubber"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone rubber"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Modeling clay"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Natural rubber"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Plasticine"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Rigid foam"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Wax"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "ABS"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Wood along the grain"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Aluminum"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Glass"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Steel"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone, Shore A 10"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone, Shore A 20"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone, Shore A 30"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone, Shore A 40"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone, Shore A 50"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Silicone, Shore A 60"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Putty"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Warm wax"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Water clay"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Oil clay"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "TPU 85A"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "TPU 95A"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "PLA"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "PETG"),
                                                         QT_TRANSLATE_NOOP("MaterialName", "Nylon PA12")};

[[maybe_unused]] const char* const unitsOfFiles[] = {QT_TRANSLATE_NOOP("ImportDialog", "As the file says"),
                                                     QT_TRANSLATE_NOOP("ImportPanel", "As the file says")};

} // namespace

} // namespace knead
