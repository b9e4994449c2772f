// SPDX-License-Identifier: GPL-3.0-or-later
//
// What fuzzers found in the readers stays mended. A broken rule ends this process with a sentence.
#include "tests/fuzz/fuzzed_readers.h"

#include <QDir>
#include <QFile>
#include <QTest>

#include <random>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_fuzzed_readers {

fuzz::Bytes bytesOf(const std::string& text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class TestFuzzedReaders : public QObject {
    Q_OBJECT

private slots:
    /// tests/fuzz/findings/READER/what-was-wrong
    void findings()
    {
        const QDir all(QStringLiteral(TOUCHDOWN_SOURCE_DIR) + "/tests/fuzz/findings");
        int read = 0;
        for (const fuzz::FuzzedReader& reader : fuzz::readers()) {
            const QDir folder(all.filePath(QString::fromUtf8(reader.name.data())));
            for (const QString& name : folder.entryList(QDir::Files)) {
                QFile file(folder.filePath(name));
                QVERIFY(file.open(QIODevice::ReadOnly));
                reader.read(bytesOf(file.readAll().toStdString()));
                ++read;
            }
        }
        QVERIFY(read > 0);
        // Each folder is that of a reader.
        for (const QString& name : all.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            QVERIFY2(std::ranges::any_of(fuzz::readers(),
                                         [&](const fuzz::FuzzedReader& r) { return name == r.name.data(); }),
                     qPrintable(name));
    }

    void goodInputsAndTheirNeighbours()
    {
        std::mt19937 random(7);
        const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
        for (const fuzz::FuzzedReader& reader : fuzz::readers()) {
            const std::vector<std::string> seeds = reader.seeds();
            QVERIFY(!seeds.empty());
            for (int draw = 0; draw < 60; ++draw) {
                std::string text = seeds[below(seeds.size())];
                if (draw >= static_cast<int>(seeds.size()) && !text.empty())
                    for (std::size_t i = 0; i <= below(3); ++i) text[below(text.size())] = static_cast<char>(random());
                reader.read(bytesOf(text));
            }
        }
    }
};

TOUCHDOWN_TEST(TestFuzzedReaders)

} // namespace test_fuzzed_readers

#include "test_fuzzed_readers.moc"
