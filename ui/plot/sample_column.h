// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of which more arrive: the samples of one quantity, or their times. They stand in pieces of a fixed size. A
// piece does not move in memory any more once it is full; it can be replaced by the same numbers on the disk
// (ui/style/unnamed_file.h).
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace touchdown {

class SampleColumn {
public:
    static constexpr std::size_t pieceSize = std::size_t(1) << 16; // numbers: 512 KB

    SampleColumn() = default;
    SampleColumn(SampleColumn&&) noexcept = default;
    SampleColumn& operator=(SampleColumn&&) noexcept = default;
    SampleColumn(const SampleColumn&) = delete;
    SampleColumn& operator=(const SampleColumn&) = delete;
    ~SampleColumn() = default;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    double operator[](std::size_t index) const { return pieces_[index / pieceSize].numbers[index % pieceSize]; }
    /// Not after the last piece has moved to the disk.
    void push_back(double number);
    /// The same numbers for another thread: they stay as they are whatever happens here. To be read only; takes no
    /// memory of its own.
    SampleColumn twin() const;
    /// Nothing more arrives: gives back the memory that was for more.
    void shrink();

    std::size_t pieces() const { return pieces_.size(); }
    std::span<const double> piece(std::size_t index) const;
    /// Keeps the numbers of a piece alive.
    std::shared_ptr<const double[]> owner(std::size_t index) const { return pieces_[index].numbers; }
    bool onDisk(std::size_t index) const { return pieces_[index].room == 0; }
    /// `same`: the numbers of that piece on the disk.
    void replace(std::size_t index, std::shared_ptr<const double[]> same);

    /// Whether the numbers [begin, end) can be read without waiting for the disk. If not, the reading begins.
    bool atHand(std::size_t begin, std::size_t end) const;
    /// Pages of what is on the disk are held by the process no longer.
    void letGo() const;

    std::size_t bytesInMemory() const { return room_ * sizeof(double); }
    std::size_t bytesOnDisk() const;

private:
    struct Piece {
        std::shared_ptr<const double[]> numbers;
        std::size_t room; // for numbers, in memory; 0: on the disk
    };
    void resizeLast(std::size_t room);

    std::vector<Piece> pieces_;
    double* last_ = nullptr; // numbers of the last piece
    std::size_t size_ = 0;
    std::size_t room_ = 0; // of all pieces
};

} // namespace touchdown
