#include "io/picture/picture_writer.h"

#include "core/message/message.h"
#include "core/task/parallel.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/picture/ground_shadow.h"
#include "io/picture/rasterizer.h"
#include "io/picture/srgb.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace knead {

namespace {

constexpr int fineness = 3;            // samples per pixel along each side
constexpr int rowsPerBand = 32;        // pixels
constexpr double pictureMargin = 0.09; // of the picture, on each side
constexpr int largestSide = 16'384;    // pixels
constexpr float glassLines = 0.6F;     // darkness of the edges of glass, of others 1

using Rgb = Eigen::Vector3f; // linear light

Rgb linearLight(const Color& color)
{
    return {toLinear(color.r), toLinear(color.g), toLinear(color.b)};
}

/// The eye sees the part in the middle of the picture, as large as the margin allows.
Projection fit(const std::vector<MeshBody>& bodies, const std::vector<MeshBody>& glass, const PictureOptions& options)
{
    Projection p;
    p.forward = options.viewDirection.normalized();
    p.right = p.forward.cross(options.up);
    if (p.right.norm() < 1e-6 * options.up.norm()) // looking along up
        p.right = p.forward.unitOrthogonal();
    p.right.normalize();
    p.down = p.forward.cross(p.right);

    Box box; // on the screen
    for (const std::vector<MeshBody>* shown : {&bodies, &glass})
        for (const MeshBody& body : *shown)
            for (const TriangleMesh::Triangle& triangle : body.mesh.triangles)
                for (const std::uint32_t vertex : triangle)
                    box.extend(p.toScreen(body.mesh.vertices[vertex]));
    const double width = fineness * options.width;
    const double height = fineness * options.height;
    const double least = std::numeric_limits<double>::min();
    p.samplesPerMeter = (1 - 2 * pictureMargin) *
                        std::min(width / std::max(box.sizes().x(), least), height / std::max(box.sizes().y(), least));
    p.offsetX = 0.5 * width - p.samplesPerMeter * box.center().x();
    p.offsetY = 0.5 * height - p.samplesPerMeter * box.center().y();
    return p;
}

/// What is drawn of some bodies, and how.
struct Drawing {
    ScreenMesh mesh;
    std::vector<Rgb> colors;           ///< of its surfaces
    std::vector<std::uint32_t> bodies; ///< of its surfaces: between those of one there are no outlines
};

/// The surfaces of a body: itself, and its faces of other colors.
/// @return of each triangle
std::vector<std::uint32_t> addSurfaces(const MeshBody& body, std::uint32_t number, Drawing& drawing)
{
    const auto add = [&](const Color& color) {
        drawing.colors.push_back(linearLight(color));
        drawing.bodies.push_back(number);
        return static_cast<std::uint32_t>(drawing.colors.size() - 1);
    };
    std::vector<std::uint32_t> ofFace(body.faceColors.size());
    const std::uint32_t own = add(body.color);
    for (std::size_t face = 0; face < ofFace.size(); ++face)
        ofFace[face] = body.faceColors[face] ? add(*body.faceColors[face]) : own;
    std::vector<std::uint32_t> result;
    for (std::size_t t = 0; t < body.mesh.triangles.size(); ++t) {
        const std::size_t face = t < body.mesh.faceOfTriangle.size() ? body.mesh.faceOfTriangle[t] : ofFace.size();
        result.push_back(face < ofFace.size() ? ofFace[face] : own);
    }
    return result;
}

Drawing project(const std::vector<MeshBody>& bodies, const Projection& projection)
{
    Drawing drawing;
    ScreenMesh& all = drawing.mesh;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        const TriangleMesh& mesh = bodies[i].mesh;
        const auto first = static_cast<std::uint32_t>(all.places.size());
        for (const Vec3& vertex : mesh.vertices)
            all.places.push_back(projection.toScreen(vertex));
        for (const TriangleMesh::Triangle& t : mesh.triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        const CornerNormals normals = cornerNormals(mesh);
        all.normals.insert(all.normals.end(), normals.begin(), normals.end());
        const std::vector<std::uint32_t> surfaces = addSurfaces(bodies[i], i, drawing);
        all.surfaceOfTriangle.insert(all.surfaceOfTriangle.end(), surfaces.begin(), surfaces.end());
    }
    return drawing;
}

/// A bright room: light from everywhere, a little bluer from above, a lamp over the left shoulder, a weak one opposite.
class Light {
public:
    Light(const Projection& p, const Vec3& up)
        : m_up(up.cast<float>())
        , m_eye((-p.forward).cast<float>())
        , m_key((-0.75 * p.forward - 0.55 * p.right + 0.8 * up).normalized().cast<float>())
        , m_fill((-0.5 * p.forward + 0.9 * p.right + 0.1 * up).normalized().cast<float>())
        , m_half((m_key + m_eye).normalized())
    {
    }

    /// What glass leaves of what is behind it, 0..1: less where one looks along it.
    float through(const Eigen::Vector3f& normal) const
    {
        const float grazing = 1 - std::max(0.0F, normal.dot(m_eye));
        return 0.80F - 0.55F * grazing * grazing * grazing;
    }

    Rgb on(const Rgb& color, const Eigen::Vector3f& normal) const
    {
        const float sky = 0.5F + 0.5F * normal.dot(m_up);
        const Rgb ambient = sky * Rgb(0.50F, 0.53F, 0.57F) + (1 - sky) * Rgb(0.20F, 0.19F, 0.185F);
        const float key = std::max(0.0F, normal.dot(m_key));
        const float fill = std::max(0.0F, normal.dot(m_fill));
        const Rgb light = ambient + key * Rgb(0.62F, 0.60F, 0.57F) + fill * Rgb(0.07F, 0.08F, 0.10F);
        float shine = std::max(0.0F, normal.dot(m_half));
        for (int i = 0; i < 5; ++i) // to the 32nd power
            shine *= shine;
        const float grazing = 1 - std::max(0.0F, normal.dot(m_eye));
        const float rim = 0.06F * grazing * grazing * grazing;
        return softened(color.cwiseProduct(light) + Rgb::Constant(0.08F * shine + rim * sky));
    }

private:
    /// Bright colors approach white instead of being cut off, so that white parts keep their shape.
    static Rgb softened(const Rgb& color)
    {
        constexpr float knee = 0.55F;
        const auto channel = [](float c) { return c <= knee ? c : 1 - (1 - knee) * std::exp((knee - c) / (1 - knee)); };
        return color.unaryExpr(channel);
    }

    Eigen::Vector3f m_up;
    Eigen::Vector3f m_eye;
    Eigen::Vector3f m_key;
    Eigen::Vector3f m_fill;
    Eigen::Vector3f m_half;
};

class Painter {
public:
    Painter(const std::vector<MeshBody>& bodies, const std::vector<MeshBody>& glass, const PictureOptions& options)
        : m_width(options.width)
        , m_height(options.height)
        , m_projection(fit(bodies, glass, options))
        , m_solid(project(bodies, m_projection))
        , m_glass(project(glass, m_projection))
        , m_light(m_projection, options.up.normalized())
        , m_pixels(3 * static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height))
    {
        std::vector<const TriangleMesh*> meshes;
        for (const MeshBody& body : bodies)
            meshes.push_back(&body.mesh);
        // From the side the ground is a line; from below it would hide the part.
        if (m_projection.forward.dot(options.up.normalized()) < -0.15)
            m_shadow.emplace(meshes, options.up.normalized());
    }

    /// Row by row, three bytes of sRGB a pixel.
    const std::vector<std::uint8_t>& paint()
    {
        forEachBlock(static_cast<std::size_t>(m_height), rowsPerBand, [&](std::size_t begin, std::size_t end) {
            paintRows(static_cast<int>(begin), static_cast<int>(end));
        });
        return m_pixels;
    }

private:
    void paintRows(int begin, int end)
    {
        // One more row on either side, for the lines.
        const SampleBand solid = samples(m_solid, begin, end);
        const SampleBand glass = samples(m_glass, begin, end);
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < m_width; ++x) {
                Rgb sum = Rgb::Zero();
                for (int row = fineness * y; row < fineness * (y + 1); ++row)
                    for (int column = fineness * x; column < fineness * (x + 1); ++column)
                        sum += colorAt(solid, glass, column, row);
                store(x, y, sum / (fineness * fineness));
            }
    }

    SampleBand samples(const Drawing& drawing, int begin, int end) const
    {
        return rasterize(drawing.mesh, m_projection, fineness * m_width, fineness * begin - 1,
                         fineness * (end - begin) + 2);
    }

    Rgb colorAt(const SampleBand& solid, const SampleBand& glass, int x, int row) const
    {
        const Sample& behind = solid.at(x, row);
        const Rgb color = behind.surface == Sample::nothing ? backgroundAt(x, row)
                                                            : m_light.on(m_solid.colors[behind.surface], behind.normal);
        const Rgb seen = color * (1 - lineAt(m_solid, solid, x, row));
        const Sample& front = glass.at(x, row);
        if (front.surface == Sample::nothing || (behind.surface != Sample::nothing && behind.depth <= front.depth))
            return seen;
        const float share = m_light.through(front.normal);
        const Rgb pane = share * seen + (1 - share) * m_light.on(m_glass.colors[front.surface], front.normal);
        return pane * (1 - glassLines * lineAt(m_glass, glass, x, row));
    }

    Rgb backgroundAt(int x, int row) const
    {
        const float t = static_cast<float>(row) / static_cast<float>(fineness * m_height);
        const Rgb top(0.93F, 0.945F, 0.965F);
        const Rgb bottom(0.80F, 0.825F, 0.86F);
        const Rgb color = top + t * (bottom - top);
        if (!m_shadow)
            return color;
        const double shadow = m_shadow->at(m_projection.fromScreen(x + 0.5, row + 0.5), m_projection.forward);
        return color * static_cast<float>(1 - 0.36 * shadow);
    }

    /// Darkness of the line that outlines and edges get, 0..1.
    float lineAt(const Drawing& drawing, const SampleBand& band, int x, int row) const
    {
        const Sample& here = band.at(x, row);
        float darkness = 0;
        const auto compare = [&](int dx, int dy) {
            if (x + dx < 0 || x + dx >= band.width)
                return;
            const Sample& there = band.at(x + dx, row + dy);
            if (here.surface == Sample::nothing ||
                (there.surface != Sample::nothing && there.depth < here.depth && isStep(here, there)))
                return; // the line belongs to the nearer side
            const bool isOther =
                there.surface == Sample::nothing || drawing.bodies[there.surface] != drawing.bodies[here.surface];
            if (isOther || isStep(here, there))
                darkness = std::max(darkness, 0.55F);
            else if (here.normal.dot(there.normal) < 0.88F)
                darkness = std::max(darkness, 0.30F);
        };
        compare(1, 0);
        compare(-1, 0);
        compare(0, 1);
        compare(0, -1);
        return darkness;
    }

    /// Whether depth jumps by more than the slopes of the two surfaces explain.
    bool isStep(const Sample& a, const Sample& b) const
    {
        const auto slope = [&](const Sample& s) {
            const float towardsEye = std::max(0.05F, -s.normal.dot(m_projection.forward.cast<float>()));
            return std::sqrt(std::max(0.0F, 1 - towardsEye * towardsEye)) / towardsEye;
        };
        const auto size = static_cast<float>(1 / m_projection.samplesPerMeter);
        return std::abs(a.depth - b.depth) > size * (2 + 1.5F * std::max(slope(a), slope(b)));
    }

    void store(int x, int y, const Rgb& color)
    {
        const std::size_t at =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x));
        for (int channel = 0; channel < 3; ++channel)
            m_pixels[at + static_cast<std::size_t>(channel)] =
                static_cast<std::uint8_t>(std::lround(255 * toSrgb(std::clamp(color[channel], 0.0F, 1.0F))));
    }

    int m_width;
    int m_height;
    Projection m_projection;
    Drawing m_solid;
    Drawing m_glass;
    Light m_light;
    std::optional<PictureShadow> m_shadow;
    std::vector<std::uint8_t> m_pixels;
};

std::string encodePng(const std::vector<std::uint8_t>& pixels, int width, int height)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
    png_alloc_size_t size = bytes.size();
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
        throw Problem(Message("Export", "The picture cannot be compressed: %1.").with(image.message));
    bytes.resize(size);
    return bytes;
}

void check(const std::string& path, const std::vector<MeshBody>& bodies, const PictureOptions& options)
{
    const auto isEmpty = [](const MeshBody& body) { return body.mesh.empty(); };
    if (std::all_of(bodies.begin(), bodies.end(), isEmpty))
        failReading(path, Message("Export", "there is no surface to draw."));
    if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > largestSide)
        failReading(path,
                    Message("Export", "the picture must have from 1 to %1 pixels on each side.").with(largestSide));
    if (!(options.viewDirection.norm() > 0) || !(options.up.norm() > 0))
        failReading(path, Message("Export", "the directions of view and of up must not be zero."));
}

} // namespace

void writePicture(const std::string& path, const std::vector<MeshBody>& bodies, const PictureOptions& options,
                  const std::vector<MeshBody>& glass)
{
    check(path, bodies, options);
    Painter painter(bodies, glass, options);
    writeFileSafely(path, encodePng(painter.paint(), options.width, options.height));
}

} // namespace knead
