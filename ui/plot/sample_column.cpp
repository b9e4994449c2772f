// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sample_column.h"

#include <algorithm>
#include <utility>

#include "ui/style/unnamed_file.h"

namespace touchdown {

namespace {

constexpr std::size_t leastRoom = 64; // numbers

} // namespace

void SampleColumn::push_back(double number)
{
    const std::size_t at = size_ % pieceSize;
    if (at == 0) {
        pieces_.push_back({nullptr, 0});
        resizeLast(leastRoom);
    } else if (at == pieces_.back().room) {
        resizeLast(std::min(2 * at, pieceSize));
    }
    assert(pieces_.back().room > at);
    last_[at] = number;
    ++size_;
}

void SampleColumn::resizeLast(std::size_t room)
{
    Piece& piece = pieces_.back();
    const std::shared_ptr<double[]> numbers = std::make_shared_for_overwrite<double[]>(room);
    if (piece.numbers) std::copy_n(piece.numbers.get(), (size_ - 1) % pieceSize + 1, numbers.get());
    room_ += room - piece.room;
    last_ = numbers.get();
    piece = {numbers, room};
}

SampleColumn SampleColumn::twin() const
{
    SampleColumn same;
    for (const Piece& piece : pieces_) same.pieces_.push_back({piece.numbers, 0});
    same.size_ = size_;
    return same;
}

void SampleColumn::shrink()
{
    const std::size_t used = (size_ - 1) % pieceSize + 1;
    if (!pieces_.empty() && pieces_.back().room > used) resizeLast(used);
}

std::span<const double> SampleColumn::piece(std::size_t index) const
{
    return {pieces_[index].numbers.get(), std::min(pieceSize, size_ - index * pieceSize)};
}

void SampleColumn::replace(std::size_t index, std::shared_ptr<const double[]> same)
{
    Piece& piece = pieces_[index];
    room_ -= piece.room;
    piece = {std::move(same), 0};
}

bool SampleColumn::atHand(std::size_t begin, std::size_t end) const
{
    bool all = true;
    for (end = std::min(end, size_); begin < end;) {
        const std::size_t index = begin / pieceSize;
        const std::size_t next = std::min(end, (index + 1) * pieceSize);
        if (onDisk(index) && !touchdown::atHand(piece(index).subspan(begin % pieceSize, next - begin))) all = false;
        begin = next;
    }
    return all;
}

void SampleColumn::letGo() const
{
    for (std::size_t index = 0; index < pieces_.size(); ++index)
        if (onDisk(index)) touchdown::letGo(piece(index));
}

std::size_t SampleColumn::bytesOnDisk() const
{
    std::size_t numbers = 0;
    for (std::size_t index = 0; index < pieces_.size(); ++index)
        if (onDisk(index)) numbers += piece(index).size();
    return numbers * sizeof(double);
}

} // namespace touchdown
