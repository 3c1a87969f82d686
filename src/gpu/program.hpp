// SPDX-License-Identifier: MIT
// A linked program. Samplers, images and outputs are found by name; no binding number is typed
// by hand anywhere.
#pragma once

#include <map>
#include <stdexcept>
#include <string>

#include "gpu/shader_source.hpp"

namespace vitrine {

/// The driver refused a shader. `log` is the driver's text; `places` maps its line numbers.
class ShaderError : public std::runtime_error {
  public:
    ShaderError(const std::string& what, std::string driverLog, std::vector<SourceLocation> lines)
        : std::runtime_error(what + "\n" + driverLog),
          log(std::move(driverLog)),
          places(std::move(lines)) {}
    std::string log;
    std::vector<SourceLocation> places;
};

class Program {
  public:
    Program() = default;
    /// Compiles and links a full-screen fragment program. Throws ShaderError.
    static Program fragment(const ShaderKey& key, const GeneratedIncludes& generated);
    /// Compiles and links a program that draws triangles: entry/NAME.vert and .frag. Throws
    /// ShaderError.
    static Program raster(const ShaderKey& key, const GeneratedIncludes& generated);
    /// Compiles and links a compute program. Throws ShaderError.
    static Program compute(const ShaderKey& key, const GeneratedIncludes& generated);
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;

    [[nodiscard]] unsigned id() const { return id_; }
    [[nodiscard]] bool isCompute() const { return compute_; }
    /// The texture unit of a sampler, the image unit of an image, the attachment of an output; -1
    /// if the program does not use the name.
    [[nodiscard]] int unit(const std::string& name) const;
    [[nodiscard]] int outputLocation(const std::string& name) const;

  private:
    void link(const std::string& name);
    void assignUnits();
    void release();

    unsigned id_ = 0;
    bool compute_ = false;
    std::map<std::string, int> units_;
};

/// The uniform block every program may have (shaders/shared/frame_block.glsl) is bound here.
inline constexpr unsigned kFrameBlockBinding = 0;

}  // namespace vitrine
