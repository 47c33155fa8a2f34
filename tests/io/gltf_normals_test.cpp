// The normals in a glTF, read with nothing but a JSON parser.
#include "io/formats/mesh_writer.h"
#include "support/shapes.h"

#include <QtTest>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>

using namespace knead;
using nlohmann::json;

namespace {

constexpr Color red{0.8F, 0.2F, 0.0F};
constexpr Color blue{0.0F, 0.4F, 1.0F};

struct Primitive {
    std::vector<Vec3> places;  // z up
    std::vector<Vec3> normals; // z up
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

template <typename Number>
Number numberAt(const QByteArray& bytes, std::size_t offset)
{
    Number number{};
    std::memcpy(&number, bytes.constData() + offset, sizeof number);
    return number;
}

/// The primitives of all meshes of a .gltf whose buffer is within it.
std::vector<Primitive> readGltf(const std::string& path)
{
    std::ifstream file(path);
    const json root = json::parse(file);
    const std::string uri = root.at("buffers").at(0).at("uri");
    const QByteArray bytes = QByteArray::fromBase64(QByteArray::fromStdString(uri.substr(uri.find(',') + 1)));
    const auto vectors = [&](std::size_t accessorNumber) {
        const json& accessor = root.at("accessors").at(accessorNumber);
        const json& view = root.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
        const std::size_t begin =
            view.at("byteOffset").get<std::size_t>() + accessor.value("byteOffset", std::size_t{0});
        const std::size_t stride = view.value("byteStride", std::size_t{12});
        std::vector<Vec3> result;
        for (std::size_t i = 0; i < accessor.at("count").get<std::size_t>(); ++i) {
            const auto at = [&](std::size_t c) {
                return static_cast<double>(numberAt<float>(bytes, begin + i * stride + 4 * c));
            };
            result.emplace_back(at(0), -at(2), at(1));
        }
        return result;
    };
    std::vector<Primitive> primitives;
    for (const json& mesh : root.at("meshes"))
        for (const json& one : mesh.at("primitives")) {
            Primitive& primitive = primitives.emplace_back();
            primitive.places = vectors(one.at("attributes").at("POSITION"));
            primitive.normals = vectors(one.at("attributes").at("NORMAL"));
            const json& accessor = root.at("accessors").at(one.at("indices").get<std::size_t>());
            const std::size_t begin =
                root.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>()).at("byteOffset");
            for (std::size_t t = 0; t < accessor.at("count").get<std::size_t>() / 3; ++t)
                primitive.triangles.push_back({numberAt<std::uint32_t>(bytes, begin + 12 * t),
                                               numberAt<std::uint32_t>(bytes, begin + 12 * t + 4),
                                               numberAt<std::uint32_t>(bytes, begin + 12 * t + 8)});
        }
    return primitives;
}

Vec3 normalOf(const Primitive& primitive, const std::array<std::uint32_t, 3>& t)
{
    const auto& p = primitive.places;
    return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
}

} // namespace

class GltfNormalsTest : public QObject {
    Q_OBJECT

private slots:
    void edgesOfABoxAreSharp();
    void smoothSurfacesShareVertices();
    void colorsDoNotChangeNormals();
    void manyRunsOfVerticesGiveTheSame();

private:
    std::string path() const { return m_folder.path().toStdString() + "/one.gltf"; }
    QTemporaryDir m_folder;
};

void GltfNormalsTest::edgesOfABoxAreSharp()
{
    TriangleMesh box = shapes::moved(shapes::box({0.01, 0.02, 0.03}), shapes::tilt(0.4));
    writeMeshes(path(), {{"box", red, box}});
    const std::vector<Primitive> primitives = readGltf(path());
    QCOMPARE(primitives.size(), std::size_t{1});
    QCOMPARE(primitives[0].places.size(), std::size_t{24}); // each corner in three faces
    QCOMPARE(primitives[0].triangles.size(), std::size_t{12});
    for (const auto& triangle : primitives[0].triangles)
        for (const std::uint32_t vertex : triangle)
            QVERIFY((primitives[0].normals[vertex] - normalOf(primitives[0], triangle)).norm() < 1e-5);
    // The triangles are those of the box.
    for (std::size_t t = 0; t < 12; ++t)
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY((primitives[0].places[primitives[0].triangles[t][i]] - box.vertices[box.triangles[t][i]]).norm() <
                    1e-8);
}

void GltfNormalsTest::smoothSurfacesShareVertices()
{
    const double R = 0.03;
    const TriangleMesh torus = shapes::torus(R, 0.01, 120, 60);
    writeMeshes(path(), {{"ring", red, torus}});
    const Primitive ring = readGltf(path()).front();
    QCOMPARE(ring.places.size(), torus.vertices.size());
    for (std::size_t v = 0; v < ring.places.size(); ++v) {
        const Vec3& p = ring.places[v];
        const double r = std::hypot(p.x(), p.y());
        const Vec3 exact = Vec3(p.x() * (1 - R / r), p.y() * (1 - R / r), p.z()).normalized();
        QVERIFY(std::abs(ring.normals[v].norm() - 1) < 1e-6);
        QVERIFY2(ring.normals[v].dot(exact) > std::cos(0.02), qPrintable(QString::number(ring.normals[v].dot(exact))));
    }
}

/// A ring of two colors has the normals of a ring of one.
void GltfNormalsTest::colorsDoNotChangeNormals()
{
    TriangleMesh torus = shapes::torus(0.03, 0.01, 40, 24);
    torus.faceOfTriangle.assign(torus.triangles.size(), 0);
    writeMeshes(path(), {{"ring", red, torus}});
    const Primitive whole = readGltf(path()).front();
    for (std::size_t t = 0; t < torus.triangles.size(); t += 3)
        torus.faceOfTriangle[t] = 1;
    // Both are one face for the normals, which go by the angle between them as well.
    writeMeshes(path(), {{"ring", red, torus, {std::nullopt, blue}}});
    const std::vector<Primitive> two = readGltf(path());
    QCOMPARE(two.size(), std::size_t{2});
    QCOMPARE(two[0].triangles.size() + two[1].triangles.size(), whole.triangles.size());
    for (const Primitive& one : two)
        for (std::size_t v = 0; v < one.places.size(); ++v) {
            double nearest = 1;
            Vec3 normal = Vec3::Zero();
            for (std::size_t w = 0; w < whole.places.size(); ++w)
                if (const double distance = (whole.places[w] - one.places[v]).norm(); distance < nearest) {
                    nearest = distance;
                    normal = whole.normals[w];
                }
            QVERIFY(nearest < 1e-8);
            QVERIFY(normal.dot(one.normals[v]) > std::cos(0.02));
        }
}

/// A staircase so long that its vertices are worked on in several runs: each corner has the normal of its triangle.
void GltfNormalsTest::manyRunsOfVerticesGiveTheSame()
{
    TriangleMesh stairs;
    constexpr std::uint32_t steps = 20'000;
    for (std::uint32_t i = 0; i < steps; ++i)
        for (const double y : {0.0, 0.01})
            stairs.vertices.emplace_back(0.001 * (i / 2), y, 0.001 * ((i + 1) / 2));
    for (std::uint32_t i = 0; i + 1 < steps; ++i) {
        stairs.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
        stairs.triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
    }
    writeMeshes(path(), {{"stairs", red, stairs}});
    const Primitive read = readGltf(path()).front();
    QCOMPARE(read.triangles.size(), stairs.triangles.size());
    QCOMPARE(read.places.size(), 2 * stairs.vertices.size() - 4); // all but those at both ends have two normals
    for (std::size_t t = 0; t < read.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = read.triangles[t][i];
            QVERIFY((read.places[vertex] - stairs.vertices[stairs.triangles[t][i]]).norm() < 1e-6);
            QVERIFY(read.normals[vertex].dot(normalOf(read, read.triangles[t])) > 0.999);
        }
}

QTEST_GUILESS_MAIN(GltfNormalsTest)
#include "gltf_normals_test.moc"
