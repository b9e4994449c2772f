// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hdf5_file.h"

#include <functional>
#include <numeric>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_hdf5_group {

std::vector<double> counted(std::size_t first, std::size_t count)
{
    std::vector<double> values(count);
    std::iota(values.begin(), values.end(), static_cast<double>(first));
    return values;
}

class TestHdf5Group : public QObject {
    Q_OBJECT

private slots:
    void putAndGet()
    {
        const Hdf5Access access;
        const Hdf5Group file = createHdf5File(path("a.h5"));
        const Hdf5Group group = file.create("zeta").create("alpha");
        group.put("number", 2.5, "m", "A number");
        group.put("text", "µm", "", "A text");
        group.put("list", std::vector<double>{1.0, 2.0});
        QCOMPARE(file.get("zeta/alpha/number").numbers(), std::vector<double>{2.5});
        QCOMPARE(group.get("number").attribute("unit"), std::string("m"));
        QCOMPARE(group.get("text").text(), std::string("µm"));
        QCOMPARE(group.get("text").attribute("unit"), std::string("1"));
        QCOMPARE(group.get("list").attribute("unit"), std::string());
        QCOMPARE(group.get("list").column(), (std::vector<double>{1.0, 2.0}));
        file.create("beta");
        QCOMPARE(file.names(), (std::vector<std::string>{"zeta", "beta"})); // in the order of creation
        file.remove("beta");
        QVERIFY(!file.has("beta"));
        file.set("status", "begun");
        file.set("status", "ended");
        QCOMPARE(file.attribute("status"), std::string("ended"));
        QVERIFY_EXCEPTION_THROWN(file.get("none"), Hdf5Error);
    }

    void anExistingFileIsNotReplaced()
    {
        const Hdf5Access access;
        createHdf5File(path("c.h5")).set("status", "first");
        QVERIFY_EXCEPTION_THROWN(createHdf5File(path("c.h5")), Hdf5Error);
        QCOMPARE(openHdf5File(path("c.h5")).attribute("status"), std::string("first"));
    }

    /// As HDF5 itself locks a file that it writes.
    void aLockIsNamed()
    {
        const Hdf5Access access;
        createHdf5File(path("d.h5")).close();
        const int descriptor = ::open(path("d.h5").c_str(), O_RDONLY | O_CLOEXEC);
        QCOMPARE(::flock(descriptor, LOCK_EX | LOCK_NB), 0);
        std::string problem;
        try {
            openHdf5File(path("d.h5"));
        } catch (const Hdf5Error& error) {
            problem = error.what();
        }
        ::close(descriptor);
        QCOMPARE(problem, std::string("another program has it open"));
    }

    void texts()
    {
        const Hdf5Access access;
        const Hdf5Group file = createHdf5File(path("texts.h5"));
        const std::vector<std::string> texts{"µm", "", "a \"longer\" one\nof two lines"};
        file.put("texts", texts);
        file.put("none", std::vector<std::string>{});
        file.put("numbers", std::vector<double>{1.0});
        QCOMPARE(file.get("texts").texts(), texts);
        QVERIFY(file.get("none").texts().empty());
        QVERIFY(file.get("none").holdsTexts());
        QVERIFY(!file.get("numbers").holdsTexts());
        QVERIFY_EXCEPTION_THROWN(file.get("numbers").texts(), Hdf5Error);
    }

    void table()
    {
        const Hdf5Access access;
        const Hdf5Group file = createHdf5File(path("b.h5"));
        const std::vector<double> values = counted(0, 6);
        const Hdf5Dataset dataset = file.table("table", 2, 3, values.data(), "Pa", "A table");
        QCOMPARE(dataset.shape(), (std::vector<hsize_t>{2, 3}));
        QCOMPARE(dataset.numbers(), values);
        QVERIFY_EXCEPTION_THROWN(dataset.column(), Hdf5Error);
    }

    /// The second file holds a beginning of the first; chunks hold 8192 numbers, or rows of a matrix of 300 x 500.
    void copiesWhatIsMissing_data()
    {
        QTest::addColumn<std::vector<hsize_t>>("entry");
        QTest::addColumn<int>("present");
        QTest::addColumn<int>("entries");
        QTest::newRow("nothing present") << std::vector<hsize_t>{} << 0 << 10000;
        QTest::newRow("part of a chunk") << std::vector<hsize_t>{} << 5000 << 20000;
        QTest::newRow("matrices of several chunks") << std::vector<hsize_t>{300, 500} << 1 << 3;
    }
    void copiesWhatIsMissing()
    {
        QFETCH(std::vector<hsize_t>, entry);
        QFETCH(int, present);
        QFETCH(int, entries);
        const auto size = std::accumulate(entry.begin(), entry.end(), std::size_t{1}, std::multiplies<>());
        const Hdf5Access access;
        for (const char* name : {"from.h5", "to.h5"}) std::filesystem::remove(path(name));
        const Hdf5Group from = createHdf5File(path("from.h5")), to = createHdf5File(path("to.h5"));
        const Hdf5Dataset source = from.growing("a", "m", "An array", entry);
        const Hdf5Dataset target = to.growing("a", "m", "An array", entry);
        source.append(counted(0, static_cast<std::size_t>(present) * size));
        target.copyMissing(source);
        source.append(
            counted(static_cast<std::size_t>(present) * size, static_cast<std::size_t>(entries - present) * size));
        target.copyMissing(source);
        QCOMPARE(target.length(), static_cast<hsize_t>(entries));
        QCOMPARE(target.numbers(), counted(0, static_cast<std::size_t>(entries) * size));
        QCOMPARE(target.entry(1), counted(size, size));
        QCOMPARE(target.storedBytes(), source.storedBytes());
    }

private:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }
    QTemporaryDir folder_;
};

TOUCHDOWN_TEST(TestHdf5Group)

} // namespace test_hdf5_group

#include "test_hdf5_group.moc"
