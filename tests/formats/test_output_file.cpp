// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/output_file.h"

#include <cerrno>
#include <csignal>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
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
        const fs::path file = target.isEmpty() ? fs::path() : path(qPrintable(target));
        const std::string obstacle = outputObstacle(file);
        QVERIFY2(obstacle.find(says.toStdString()) != std::string::npos, obstacle.c_str());
        QCOMPARE(checkOutputFile(file), "cannot write to " + file.string() + ": " + obstacle);
        QCOMPARE(outputObstacle(path("new")), std::string());
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
    }

    void anUnfinishedFileIsRemoved()
    {
        write(path("a"), "old");
        {
            const PartFile part(path("a"));
            write(part.path(), "half");
        }
        QCOMPARE(read(path("a")), std::string("old"));
        QCOMPARE(files(), QStringList{"a"});
    }

    void aFailureIsThrown()
    {
        QVERIFY_EXCEPTION_THROWN(PartFile(path("none/a")), std::system_error);
        const PartFile part(path("a"), PartName::Own);
        QVERIFY_EXCEPTION_THROWN(part.show(), std::system_error); // it was never created
    }

    void aPartHasTheModeOfTheOldFileFromTheBeginning()
    {
        write(path("a"), "old");
        fs::permissions(path("a"), fs::perms(0600));
        const PartFile unnamed(path("a")), named(path("b"), PartName::Own);
        write(path("b"), "old");
        fs::permissions(path("b"), fs::perms(0600));
        for (const PartFile* part : {&unnamed, &named}) {
            const int descriptor = part->create();
            QVERIFY(descriptor >= 0);
            ::close(descriptor);
            QCOMPARE(fs::status(part->path()).permissions(), fs::perms(0600));
        }
        QCOMPARE(named.create(), -1);
        QCOMPARE(errno, EEXIST);
    }

    void oneWriterAtATime()
    {
        fs::create_symlink("a", path("link"));
        write(path("a"), "old");
        {
            const PartFile first(path("a"));
            QVERIFY_EXCEPTION_THROWN(PartFile(path("a")), std::runtime_error);
            QVERIFY_EXCEPTION_THROWN(PartFile(path("link")), std::runtime_error);
            QVERIFY_EXCEPTION_THROWN(OutputLock(path("a")), std::runtime_error);
            const PartFile other(path("b"));
            write(first.path(), "new"); // the refused ones touched nothing
            first.show();
            QVERIFY_EXCEPTION_THROWN(PartFile(path("a")), std::runtime_error); // until its end
        }
        QCOMPARE(read(path("a")), std::string("new"));
        QVERIFY(PartFile(path("a")).target() == fs::canonical(path("a")));
        QCOMPARE(files(), (QStringList{"a", "link"}));
    }

    /// A child writes as commands do, and is killed before it shows its files.
    void aKilledProgramLeavesNothingBesideAFileThatItHasNotShown()
    {
        write(path("a"), "old");
        int told[2];
        QCOMPARE(::pipe(told), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const PartFile first(path("a")), second(path("b"));
            write(first.path(), "half");
            write(second.path(), "half");
            if (::write(told[1], ".", 1) == 1) ::pause();
            ::_exit(1);
        }
        char dot = 0;
        QCOMPARE(::read(told[0], &dot, 1), ssize_t{1});
        QVERIFY_EXCEPTION_THROWN(PartFile(path("b")), std::runtime_error);
        ::kill(child, SIGKILL);
        QCOMPARE(::waitpid(child, nullptr, 0), child);
        for (const int end : told) ::close(end);
        if (PartFile(path("c")).isNamed()) QSKIP("the file system has no files without a name");
        QCOMPARE(files(), QStringList{"a"});
        QCOMPARE(read(path("a")), std::string("old"));
    }

    /// Of all files in the folder; only names that the program gives, and no links.
    void leftoversOfKilledProgramsAreRemoved()
    {
        for (const char* name : {"a.touchdown.0123abcd.part", "b.h5.touchdown.0123abcd.part"})
            write(path(name), "half");
        for (const char* name : {"a.touchdown.lock", "c.touchdown.lock"}) write(path(name), "");
        const QStringList others{"a.part",   "a.touchdown.0123abcx.part", "a.touchdown.0123abcd.partly",
                                 "precious", ".touchdown.0123abcd.part",  "d.touchdown.lock"};
        for (const QString& other : others) write(path(qPrintable(other)), "mine");
        fs::create_symlink("precious", path("a.touchdown.89abcdef.part"));
        fs::create_symlink("precious", path("e.touchdown.lock"));
        {
            const OutputLock atWork(path("x"));
            write(path("x.touchdown.0123abcd.part"), "half");
            static_cast<void>(OutputLock(path("a")));
            QVERIFY_EXCEPTION_THROWN(OutputLock(path("x")), std::runtime_error);
        }
        QStringList left =
            others + QStringList{"a.touchdown.89abcdef.part", "e.touchdown.lock", "x.touchdown.0123abcd.part"};
        left.sort();
        QCOMPARE(files(), left);
        for (const QString& other : others) QCOMPARE(read(path(qPrintable(other))), std::string("mine"));
    }
    /// By the file system, which programs of other containers and computers see, too.
    void aLockIsSeenByOtherPrograms()
    {
        const OutputLock first(path("a"));
        const int other = ::open(path("a.touchdown.lock").c_str(), O_RDONLY | O_CLOEXEC);
        QVERIFY(other >= 0);
        QVERIFY(::flock(other, LOCK_EX | LOCK_NB) != 0);
        ::close(other);
    }

    /// Also one whose file is not there yet.
    void aLinkStaysOne()
    {
        fs::create_symlink("later", path("link"));
        QCOMPARE(linkTarget(path("link")), fs::weakly_canonical(path("later")));
        const OutputLock lock(path("later"));
        QVERIFY_EXCEPTION_THROWN(OutputLock(path("link")), std::runtime_error);
    }

    void whatIsNoLockStays_data()
    {
        QTest::addColumn<bool>("link");
        QTest::newRow("a file") << false;
        QTest::newRow("a symbolic link") << true;
    }
    void whatIsNoLockStays()
    {
        QFETCH(const bool, link);
        write(path("mine"), "mine");
        if (link)
            fs::create_symlink("mine", path("a.touchdown.lock"));
        else
            write(path("a.touchdown.lock"), "mine");
        QVERIFY_EXCEPTION_THROWN(OutputLock(path("a")), std::runtime_error);
        QCOMPARE(read(path("a.touchdown.lock")), std::string("mine"));
        QCOMPARE(fs::is_symlink(path("a.touchdown.lock")), link);
    }

    void theLongestName()
    {
        const std::string name(255, 'a');
        const PartFile part(path(name.c_str()));
        write(part.path(), "new");
        part.show();
        QCOMPARE(read(path(name.c_str())), std::string("new"));
    }

    void longNamesThatDifferAtTheirEndHaveTheirOwnLocks()
    {
        for (const std::size_t length : {231u, 232u, 251u, 254u}) {
            const std::string name(length, 'a');
            const PartFile first(path((name + 'b').c_str())), second(path((name + 'c').c_str()));
            QVERIFY_EXCEPTION_THROWN(PartFile(path((name + 'b').c_str())), std::runtime_error);
            write(first.path(), "first");
            write(second.path(), "second");
            first.show();
            second.show();
            QCOMPARE(read(path((name + 'b').c_str())), std::string("first"));
            QCOMPARE(read(path((name + 'c').c_str())), std::string("second"));
        }
    }

private:
    QStringList files() const
    {
        return QDir(folder_->path()).entryList(QDir::Files | QDir::System | QDir::Hidden, QDir::Name);
    }
    fs::path path(const char* name) const { return fs::path(folder_->path().toStdString()) / name; }
    std::unique_ptr<QTemporaryDir> folder_;
};

TOUCHDOWN_TEST(TestOutputFile)

} // namespace test_output_file

#include "test_output_file.moc"
