#pragma once

#include "support/shapes.h"

#include <QTest>

/// How parts lie in the lattice: rows of a test's data.
namespace knead::turns {

inline const Quaternion inThreeAxes =
    shapes::about(17, Vec3::UnitX()) * shapes::about(23, Vec3::UnitY()) * shapes::about(31, Vec3::UnitZ());

/// A column "turn": along the lattice, across it and tilted.
inline void addRows()
{
    QTest::addColumn<Quaternion>("turn");
    QTest::newRow("along the lattice") << Quaternion::Identity();
    QTest::newRow("29 degrees across") << shapes::about(29, Vec3::UnitY());
    QTest::newRow("tilted in three axes") << inThreeAxes;
}

} // namespace knead::turns
