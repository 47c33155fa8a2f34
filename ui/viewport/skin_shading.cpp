#include "ui/viewport/skin_shading.h"

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>

#include <string>

namespace knead {

namespace {

constexpr const char* lightPlace = "//VTK::Light::Impl"; // in VTK's shader of fragments: after it the light is computed

// Both see the normal, normalVCVSOutput, and the place, vertexVC, as the eye does, which looks along -z; diffuseColor is the color of
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

std::string lightOf(Shading shading)
{
    if (shading == Shading::polished)
        return polishedLight;
    return shading == Shading::zebra ? zebraLight : std::string();
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
    if (shading == Shading::clay)
        return {0.79F, 0.61F, 0.49F};
    return shading == Shading::zebra ? Color{0.97F, 0.97F, 0.97F} : own;
}

void shadeFaces(vtkActor& faces, Shading shading, MaterialLook look)
{
    if (shading == Shading::usual)
        setUsual(*faces.GetProperty(), look);
    else if (shading == Shading::clay)
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
