// SPDX-License-Identifier: MIT
#include "gpu/image_store.hpp"

#include <algorithm>
#include <utility>

namespace vitrine {

std::shared_ptr<ImageStore> ImageStore::create() {
    return std::shared_ptr<ImageStore>(new ImageStore);
}

Texture ImageStore::take(int width, int height, TexelFormat format) {
    Texture image;
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::find_if(kept_.rbegin(), kept_.rend(), [&](const Texture& kept) {
            return kept.width() == width && kept.height() == height && kept.format() == format;
        });
        if (found != kept_.rend()) {
            image = std::move(*found);
            kept_.erase(std::next(found).base());
            keptBytes_ -= image.bytes();
        }
    }
    if (!image.valid()) image = Texture(width, height, format);
    image.home_ = shared_from_this();
    std::vector<Texture> gone;
    const std::lock_guard lock(mutex_);
    usedBytes_ += image.bytes();
    mostBytes_ = std::max(mostBytes_, usedBytes_);
    gone = surplus();
    return image;
}

void ImageStore::giveBack(Texture image) {
    std::vector<Texture> gone;
    const std::lock_guard lock(mutex_);
    usedBytes_ -= image.bytes();
    keptBytes_ += image.bytes();
    kept_.push_back(std::move(image));
    gone = surplus();
}

void ImageStore::settle() {
    std::vector<Texture> gone;
    const std::lock_guard lock(mutex_);
    mostBytes_ = usedBytes_;
    gone = surplus();
}

std::vector<Texture> ImageStore::surplus() {
    // Room for a whole set while a coarse one is in use, and for some of those.
    const size_t most = mostBytes_ + mostBytes_ / 2;
    auto end = kept_.begin();
    for (; end != kept_.end() && usedBytes_ + keptBytes_ > most; ++end) keptBytes_ -= end->bytes();
    std::vector<Texture> gone(std::make_move_iterator(kept_.begin()), std::make_move_iterator(end));
    kept_.erase(kept_.begin(), end);
    return gone;
}

size_t ImageStore::bytesInUse() const {
    const std::lock_guard lock(mutex_);
    return usedBytes_;
}

size_t ImageStore::bytesKept() const {
    const std::lock_guard lock(mutex_);
    return keptBytes_;
}

}  // namespace vitrine
