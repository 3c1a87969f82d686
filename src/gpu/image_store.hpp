// SPDX-License-Identifier: MIT
// Images that nobody needs any more, for those who need such next: a picture that is coarse while
// it moves and whole when it rests goes to and fro between two sets of images, and every change of
// a scene needs the same ones again. New ones would cost time for every page of memory.
//
// Between contexts that share textures, on any of their threads.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "gpu/texture.hpp"

namespace vitrine {

class ImageStore : public std::enable_shared_from_this<ImageStore> {
  public:
    static std::shared_ptr<ImageStore> create();
    /// The last one to let go of it, or of an image of it, has a context.
    ~ImageStore() = default;
    ImageStore(const ImageStore&) = delete;
    ImageStore& operator=(const ImageStore&) = delete;

    /// An image that comes back here when it goes. What is in it is not known. A context is
    /// current.
    [[nodiscard]] Texture take(int width, int height, TexelFormat format);
    /// What was in use at once no longer tells what will be needed; what is now does. A context is
    /// current.
    void settle();
    /// Of images in use, and of those that are kept for the next.
    [[nodiscard]] size_t bytesInUse() const;
    [[nodiscard]] size_t bytesKept() const;

  private:
    friend class Texture;
    ImageStore() = default;
    void giveBack(Texture image);
    /// Takes out the oldest until all there is, used and kept, is no more than one and a half times
    /// the most that was in use at once. To be destroyed without the lock.
    [[nodiscard]] std::vector<Texture> surplus();

    mutable std::mutex mutex_;
    std::vector<Texture> kept_;  ///< the oldest first
    size_t keptBytes_ = 0, usedBytes_ = 0;
    size_t mostBytes_ = 0;  ///< in use at once, since settle()
};

}  // namespace vitrine
