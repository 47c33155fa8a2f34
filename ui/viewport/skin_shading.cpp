#include "ui/viewport/skin_shading.h"

#include <QCoreApplication>

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace knead {

namespace {

constexpr const char* lightPlace = "//VTK::Light::Impl"; // in VTK's shader of fragments: after it the light is computed

// All see the normal, normalVCVSOutput, and the place, vertexVC, as the eye does, which looks along -z; diffuseColor is the color of
// the face. They come after VTK's own light, which they replace but for the opacity. GLSL 1.50, as of OpenGL 3.2.

// A studio, by the part of the normal that points to the right and up, seen from the face: bright above, dark at the rims, a round lamp
// and a strip of light.
constexpr const char* polishedLight = R"(//VTK::Light::Impl
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 toSide = normalize(cross(vec3(0.0, 1.0, 0.0), toEye));
  vec2 studio = vec2(dot(normalVCVSOutput, toSide), dot(normalVCVSOutput, cross(toEye, toSide)));
  float sky = smoothstep(-0.1, 0.9, studio.y);
  float ground = 1.0 - smoothstep(-0.85, -0.05, studio.y);
  float lamp = 1.0 - smoothstep(0.18, 0.30, distance(studio, vec2(-0.38, 0.52)));
  float strip = (1.0 - smoothstep(0.04, 0.10, abs(studio.x - 0.72))) * (1.0 - smoothstep(0.45, 0.75, abs(studio.y)));
  float rim = smoothstep(0.80, 1.0, length(studio));
  float gray = 0.42 + 0.50 * sky + 0.16 * ground - 0.26 * rim;
  gl_FragData[0].rgb = clamp(gray * diffuseColor + vec3(0.75 * lamp + 0.4 * strip), 0.0, 1.0);
)";

// The angle of the mirrored line of sight with the vertical of the view tells the stripe. Its edges are a pixel wide.
constexpr const char* zebraLight = R"(//VTK::Light::Impl
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 mirrored = reflect(-toEye, normalVCVSOutput);
  float stripe = 8.0 * acos(clamp(mirrored.y, -1.0, 1.0)) / 3.14159265;
  float inStripe = abs(fract(stripe) - 0.5) - 0.25;
  float bright = clamp(inStripe / max(fwidth(stripe), 0.001) + 0.5, 0.0, 1.0);
  gl_FragData[0].rgb = mix(vec3(0.06), diffuseColor, bright) * (0.75 + 0.25 * max(0.0, normalVCVSOutput.z));
)";

// Wraps around the shape, so that nothing is black; rims let through what light is behind them; a wide, faint shine.
constexpr const char* waxLight = R"(//VTK::Light::Impl
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 lamp = normalize(vec3(-0.45, 0.75, 0.65));
  float facing = max(0.0, dot(normalVCVSOutput, toEye));
  float wrapped = 0.5 + 0.5 * dot(normalVCVSOutput, lamp);
  float through = pow(1.0 - facing, 2.5);
  float shine = pow(max(0.0, dot(normalVCVSOutput, normalize(lamp + toEye))), 14.0);
  vec3 warm = mix(diffuseColor * vec3(0.62, 0.50, 0.46), diffuseColor, smoothstep(0.05, 0.95, wrapped));
  vec3 wax = (0.28 + 0.58 * wrapped) * warm + 0.20 * shine;
  wax += 0.40 * through * mix(diffuseColor, vec3(1.0, 0.86, 0.70), 0.6);
  gl_FragData[0].rgb = clamp(wax, 0.0, 1.0);
)";

// The mirrored line of sight meets the sky, the sharp line of the horizon or the ground; marks on faces tint it.
constexpr const char* chromeLight = R"(//VTK::Light::Impl
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 mirrored = reflect(-toEye, normalVCVSOutput);
  float height = mirrored.y + 0.12 * sin(3.0 * mirrored.x);
  float sky = mix(0.96, 0.42, smoothstep(0.0, 0.85, height));
  float ground = mix(0.10, 0.52, smoothstep(0.0, 0.9, -height));
  float line = max(fwidth(height), 0.03);
  float gray = mix(ground, sky, smoothstep(-line, line, height));
  float lamp = 1.0 - smoothstep(0.10, 0.22, distance(mirrored.xy, vec2(-0.62, 0.58)));
  float rim = smoothstep(0.75, 1.0, length(normalVCVSOutput.xy));
  vec3 chrome = vec3(gray + 0.5 * lamp) * mix(1.0, 0.72, rim) * vec3(0.97, 0.985, 1.0);
  gl_FragData[0].rgb = clamp(chrome * diffuseColor, 0.0, 1.0);
)";

// Even light below, glaze above: two windows with soft edges are mirrored, rims mirror more than the middle.
constexpr const char* porcelainLight = R"(//VTK::Light::Impl
  vec3 toEye = cameraParallel != 0 ? vec3(0.0, 0.0, 1.0) : normalize(-vertexVC.xyz);
  vec3 mirrored = reflect(-toEye, normalVCVSOutput);
  float wrapped = 0.5 + 0.5 * dot(normalVCVSOutput, normalize(vec3(-0.40, 0.80, 0.45)));
  vec2 left = abs(mirrored.xy - vec2(-0.52, 0.46)) - vec2(0.13, 0.20);
  vec2 right = abs(mirrored.xy - vec2(0.66, 0.20)) - vec2(0.06, 0.26);
  float panes = 1.0 - smoothstep(0.0, 0.09, max(left.x, left.y));
  panes += 0.45 * (1.0 - smoothstep(0.0, 0.09, max(right.x, right.y)));
  float rim = pow(1.0 - max(0.0, dot(normalVCVSOutput, toEye)), 3.0);
  vec3 shadow = diffuseColor * vec3(0.50, 0.55, 0.66);
  vec3 body = mix(shadow, 0.90 * diffuseColor, smoothstep(0.10, 1.0, wrapped));
  gl_FragData[0].rgb = clamp(mix(body, vec3(0.78, 0.82, 0.88), 0.45 * rim) + 0.30 * panes, 0.0, 1.0);
)";

// Lights may add up to more than white. What is brighter than `knee` nears white ever more slowly, so that a white part
// keeps its gradients; what is darker stays as it is. All channels by the same share, so that colors stay what they are.
constexpr const char* softLight = R"(//VTK::Light::Impl
  const float knee = 0.75;
  float brightest = max(gl_FragData[0].r, max(gl_FragData[0].g, gl_FragData[0].b));
  if (brightest > knee)
    gl_FragData[0].rgb *= (1.0 - (1.0 - knee) * exp(-(brightest - knee) / (1.0 - knee))) / brightest;
)";

std::string lightOf(Shading shading)
{
    switch (shading) {
    case Shading::usual:
    case Shading::clay:
    case Shading::curvature:
        break;
    case Shading::polished:
        return polishedLight;
    case Shading::zebra:
        return zebraLight;
    case Shading::wax:
        return waxLight;
    case Shading::chrome:
        return chromeLight;
    case Shading::porcelain:
        return porcelainLight;
    }
    return softLight;
}

void setSurface(vtkProperty& surface, double ambient, double diffuse, double specular, double power)
{
    surface.SetAmbient(ambient);
    surface.SetDiffuse(diffuse);
    surface.SetSpecular(specular);
    surface.SetSpecularPower(power);
}

void setUsual(vtkProperty& surface, MaterialLook look)
{
    switch (look) {
    case MaterialLook::plain:
        return setSurface(surface, 0.33, 0.74, 0.12, 24);
    case MaterialLook::rubber:
        return setSurface(surface, 0.33, 0.74, 0.05, 6);
    case MaterialLook::clay:
        return setSurface(surface, 0.33, 0.76, 0, 1);
    case MaterialLook::wood:
        return setSurface(surface, 0.33, 0.74, 0.07, 12);
    case MaterialLook::plastic:
        return setSurface(surface, 0.31, 0.74, 0.30, 50);
    case MaterialLook::metal:
        return setSurface(surface, 0.28, 0.70, 0.50, 70);
    }
}

} // namespace

Color colorFor(Shading shading, const Color& own)
{
    switch (shading) {
    case Shading::clay:
        return {0.79F, 0.61F, 0.49F};
    case Shading::zebra:
    case Shading::chrome:
    case Shading::porcelain:
        return {0.97F, 0.97F, 0.97F};
    case Shading::curvature:
        return colorAt(curvatureScale().map, 0.5);
    case Shading::usual:
    case Shading::polished:
    case Shading::wax:
        break;
    }
    return own;
}

Color curvatureTint(float bend)
{
    constexpr double contrast =
        0.7; // of the half of the map per bend: what is half as bent as can be has strong colors already
    const ColorTable& table = colorTable(curvatureScale().map);
    const double share = std::clamp(0.5 - contrast * static_cast<double>(bend), 0.0, 1.0);
    const auto& color = table[static_cast<std::size_t>(std::lround(share * (table.size() - 1)))];
    const Color flat = colorFor(Shading::curvature, {});
    return {static_cast<float>(color[0]) / 255 / flat.r, static_cast<float>(color[1]) / 255 / flat.g,
            static_cast<float>(color[2]) / 255 / flat.b};
}

ColorScale curvatureScale()
{
    return {.map = ColorMap::diverging, .least = -1, .most = 1};
}

ScaleText curvatureText()
{
    const auto said = [](const char* text) { return QCoreApplication::translate("Curvature", text); };
    return {.title = said(QT_TRANSLATE_NOOP("Curvature", "Curvature")),
            .ticks = {{0, said(QT_TRANSLATE_NOOP("Curvature", "concave"))},
                      {0.5, said(QT_TRANSLATE_NOOP("Curvature", "flat"))},
                      {1, said(QT_TRANSLATE_NOOP("Curvature", "convex"))}}};
}

void shadeFaces(vtkActor& faces, Shading shading, MaterialLook look)
{
    if (shading == Shading::usual)
        setUsual(*faces.GetProperty(), look);
    else if (shading == Shading::clay || shading == Shading::curvature)
        setSurface(*faces.GetProperty(), 0.26, 0.80, 0.0, 1);
    else
        setSurface(*faces.GetProperty(), 0, 1, 0, 1); // so that diffuseColor is that of the face
    vtkShaderProperty& shader = *faces.GetShaderProperty();
    const std::string wanted = lightOf(shading);
    std::string name;
    std::string present;
    bool isFirst = true;
    bool isAll = false;
    if (shader.GetNumberOfShaderReplacements() > 0)
        shader.GetNthShaderReplacement(0, name, isFirst, present, isAll);
    if (present == wanted)
        return; // or the shader would be compiled anew
    shader.ClearAllShaderReplacements();
    if (!wanted.empty())
        shader.AddFragmentShaderReplacement(lightPlace, true, wanted, false);
}

} // namespace knead
