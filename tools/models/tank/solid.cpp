// SPDX-License-Identifier: MIT
#include "models/tank/solid.hpp"

#include <utility>

namespace vitrine::tank {

void Solid::triangle(Material material, const Corner& a, const Corner& b, const Corner& c) {
    // A tenth of a millimetre squared: what is less is where rows of corners end in a point.
    constexpr double kLeastArea = 1e-8;
    const Vec3 flat = glm::cross(b.at - a.at, c.at - a.at);
    if (glm::length(flat) < kLeastArea) return;
    const bool outward = glm::dot(flat, a.normal + b.normal + c.normal) > 0.0;
    triangles.push_back({{a, outward ? b : c, outward ? c : b}, material});
}

void Solid::quad(Material material, const Corner& a, const Corner& b, const Corner& c,
                 const Corner& d) {
    triangle(material, a, b, c);
    triangle(material, a, c, d);
}

void Solid::append(const Solid& other, const Mat4& at) {
    const glm::dmat3 turn(at);
    const glm::dmat3 normalTurn = glm::transpose(glm::inverse(turn));
    const bool mirrored = glm::determinant(turn) < 0.0;
    triangles.reserve(triangles.size() + other.triangles.size());
    for (Triangle t : other.triangles) {
        for (Corner& c : t.corners)
            c = {Vec3(at * glm::dvec4(c.at, 1.0)), glm::normalize(normalTurn * c.normal)};
        if (mirrored) std::swap(t.corners[1], t.corners[2]);
        triangles.push_back(t);
    }
}

void Solid::appendBothSides(const Solid& other, const Mat4& at) {
    append(other, at);
    append(other, glm::scale(Mat4(1.0), Vec3(1, 1, -1)) * at);
}

Mat4 moved(const Vec3& by) {
    return glm::translate(Mat4(1.0), by);
}

Mat4 turned(const Vec3& degrees) {
    Mat4 turn = glm::rotate(Mat4(1.0), glm::radians(degrees.z), Vec3(0, 0, 1));
    turn = glm::rotate(turn, glm::radians(degrees.y), Vec3(0, 1, 0));
    return glm::rotate(turn, glm::radians(degrees.x), Vec3(1, 0, 0));
}

Mat4 standing(const Vec3& at, const Vec3& up, const Vec3& ahead) {
    const Vec3 y = glm::normalize(up);
    const Vec3 z = glm::normalize(glm::cross(ahead, y));
    return {glm::dvec4(glm::cross(y, z), 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(at, 1)};
}

}  // namespace vitrine::tank
