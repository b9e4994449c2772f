// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/output_file.h"

#include <fstream>
#include <memory>
#include <system_error>

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_output_file {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

std::string read(const fs::path& file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class TestOutputFile : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void refusedTargets_data()
    {
        QTest::addColumn<QString>("target"); // in the folder, unless absolute
        QTest::addColumn<QString>("says");
        QTest::newRow("a directory") << "sub"
                                     << "is a directory";
        QTest::newRow("a directory with a slash") << "sub/"
                                                  << "names no file";
        QTest::newRow("in no directory") << "none/run.h5"
                                         << "there is no directory";
        QTest::newRow("in a file") << "file/run.h5"
                                   << "there is no directory";
        QTest::newRow("a device") << "/dev/full"
                                  << "is no regular file";
        QTest::newRow("no name") << ""
                                 << "names no file";
    }
    void refusedTargets()
    {
        QFETCH(QString, target);
        QFETCH(QString, says);
        fs::create_directory(path("sub"));
        write(path("file"), "text");
        const std::string problem = checkOutputFile(target.isEmpty() ? fs::path() : path(qPrintable(target)));
        QVERIFY2(problem.find(says.toStdString()) != std::string::npos, problem.c_str());
        QCOMPARE(checkOutputFile(path("file")), std::string());
        QCOMPARE(checkOutputFile(path("new")), std::string());
    }

    void theOldFileStaysUntilTheNewOneIsShown()
    {
        write(path("a"), "old");
        fs::permissions(path("a"), fs::perms(0640));
        fs::create_symlink("a", path("link"));
        PartFile part(path("link"));
        write(part.path(), "new");
        QCOMPARE(read(path("a")), std::string("old"));
        part.show();
        QCOMPARE(read(path("a")), std::string("new"));
        QVERIFY(fs::is_symlink(path("link")));
        QCOMPARE(fs::status(path("a")).permissions(), fs::perms(0640));
        QVERIFY(!fs::exists(path("a.part")));
    }

    void anUnfinishedFileIsRemoved()
    {
        write(path("a"), "old");
        write(path("a.part"), "of an interrupted program");
        {
            const PartFile part(path("a"));
            QVERIFY(!fs::exists(path("a.part")));
            write(part.path(), "half");
        }
        QVERIFY(!fs::exists(path("a.part")));
        QCOMPARE(read(path("a")), std::string("old"));
    }

    void aFailureIsThrown()
    {
        PartFile part(path("none/a"));
        QVERIFY_EXCEPTION_THROWN(part.show(), std::system_error);
    }

private:
    fs::path path(const char* name) const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestOutputFile)

} // namespace test_output_file

#include "test_output_file.moc"
