// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml_case.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

#include "core/case/parameters.h"
#include "core/case_files/case_reader.h"
#include "core/formats/quotation.h"
#include "core/formats/units.h"
#include "core/physics/film/slip_model.h"
#include "tests/support/cml_sample.h"
#include "tests/support/random_case.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_case {

namespace fs = std::filesystem;

/// A folder in which files are put.
class Folder {
public:
    fs::path path(const std::string& name = {}) const { return fs::path(folder_.path().toStdString()) / name; }
    void put(const std::string& name, const std::string& text) const
    {
        fs::create_directories(path(name).parent_path());
        QVERIFY(writeTextFile(path(name), text).empty());
    }
    void putSample(const std::string& name) const
    {
        put(name + "/rail.dat", cmlRailText());
        put(name + "/run.dat", cmlRunText());
    }
    QStringList entries(const std::string& name = {}) const
    {
        return QDir(QString::fromStdString(path(name).string()))
            .entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden);
    }

private:
    QTemporaryDir folder_;
};

QByteArray joined(const std::vector<InputProblem>& list, const Folder& folder)
{
    QByteArrayList lines;
    for (const InputProblem& each : list) lines << QByteArray::fromStdString(each.text());
    return lines.join('\n').replace(QByteArray::fromStdString(folder.path().string()), "");
}

/// Rails that are valid, with numbers of all digits: convex polygons about random centres.
class RandomSurface {
public:
    explicit RandomSurface(unsigned seed) : generator_(seed) {}
    AirBearingSurface surface()
    {
        AirBearingSurface s;
        s.walls.resize(static_cast<std::size_t>(whole(0, 3)));
        for (WallProfile& wall : s.walls) {
            double distance = -number(1e-6);
            for (int i = whole(2, 6); i > 0; --i) {
                wall.distance.push_back(distance += number(3e-6));
                wall.recess.push_back(number(2e-6));
            }
        }
        s.rails.resize(static_cast<std::size_t>(whole(0, 5)));
        for (Rail& rail : s.rails) {
            const double x = number(1e-3), y = number(1e-3), radius = 1e-6 + number(2e-4);
            const int count = whole(3, 9);
            for (int i = 0; i < count; ++i) {
                const double angle = 2.0 * std::numbers::pi * (i + 0.5 * number(1.0)) / count;
                rail.points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle),
                                       whole(0, static_cast<int>(s.walls.size()))});
            }
            rail.kind = whole(0, 1) == 0 ? RailKind::Step : RailKind::Ramp;
            rail.recess[0] = number(1e-6);
            if (rail.kind == RailKind::Ramp) rail.recess = {number(1e-6), number(1e-6), -number(1e-6)};
        }
        s.pointsOfInterest.resize(static_cast<std::size_t>(whole(0, 10)));
        for (SurfacePoint& p : s.pointsOfInterest) p = {number(1e-3), number(1e-3)};
        return s;
    }

private:
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(generator_); }
    double number(double most) { return std::uniform_real_distribution<double>(0.0, most)(generator_); }
    std::mt19937 generator_;
};

/// What a film case must have to make sense; see checkCombinations.
void makeSensible(Case& c)
{
    c.model = ModelKind::Film;
    c.contact = noContact;
    c.air.slip.accommodation = 1.0;
    c.steady.skews.resize(c.steady.skews.empty() ? 0 : c.steady.radii.size());
    c.surface.taperLength = std::min(c.surface.taperLength, c.slider.length);
}

class TestCmlCase : public QObject {
    Q_OBJECT

private slots:
    void whatIsACmlPath()
    {
        const Folder folder;
        folder.putSample("slider");
        folder.put("results/notes.txt", "x");
        folder.put("capital/RAIL.DAT", "x");
        for (const char* path :
             {"slider", "slider/rail.dat", "slider/run.dat", "capital", "a.cml", "a.CML", "x/DYNAMICS.DEF"})
            QVERIFY2(isCmlPath(folder.path(path)), path);
        for (const char* path : {"results", "results/notes.txt", "case.toml", "none", "rail.toml"})
            QVERIFY2(!isCmlPath(folder.path(path)), path);
    }

    void everyWayToTheSameCase_data()
    {
        QTest::addColumn<QByteArray>("path");
        QTest::newRow("folder") << QByteArray("slider");
        QTest::newRow("folder with a slash") << QByteArray("slider/");
        QTest::newRow("rail.dat") << QByteArray("slider/rail.dat");
        QTest::newRow("run.dat") << QByteArray("slider/run.dat");
        QTest::newRow("capitals") << QByteArray("capitals/slider");
        QTest::newRow("archive") << QByteArray("slider.cml");
        QTest::newRow("archive in capitals") << QByteArray("capitals/slider.CML");
    }
    void everyWayToTheSameCase()
    {
        QFETCH(QByteArray, path);
        const Folder folder;
        folder.putSample("slider");
        folder.put("capitals/slider/Rail.DAT", cmlRailText());
        folder.put("capitals/slider/RUN.dat", cmlRunText());
        const auto archive = formatCmlArchive({{"rail.dat", cmlRailText()}, {"run.dat", cmlRunText()}});
        folder.put("slider.cml", std::get<std::string>(archive));
        folder.put("capitals/slider.CML", std::get<std::string>(archive));

        const CaseDocument document = openCase(folder.path(path.toStdString()).string());
        QCOMPARE(joined(document.problems, folder), QByteArray());
        QCOMPARE(document.warnings.size(), std::size_t(1)); // of the mass
        QCOMPARE(document.name, folder.path(path.toStdString()).string());
        QCOMPARE(document.value.title, std::string("slider"));
        QVERIFY(document.value.surface == cmlSurface());
        QCOMPARE(document.value.slider.length, 1.25e-3);
        QCOMPARE(document.value.slider.thickness, 3e-4);
        QCOMPARE(document.value.suspension.preload, 1.5e-3 * 9.80665);

        // The text of the document is the same case, and bears the comments of the file.
        const CaseDocument toml = parseCase(document.text, "case.toml");
        QCOMPARE(joined(toml.problems, folder), QByteArray());
        QCOMPARE(firstDifference(toml.value, document.value), std::string());
        QVERIFY(toml.value.surface == document.value.surface);
        QVERIFY(document.text.find("# drawn for tests, pad of 5 \xc2\xb5m\n") != std::string::npos);
    }

    void railsAlone()
    {
        const Folder folder;
        folder.put("slider/rail.dat", cmlRailText());
        const CaseDocument document = readCmlCase(folder.path("slider/rail.dat"));
        QVERIFY(document.valid());
        QVERIFY(document.value.surface == cmlSurface());
        QCOMPARE(joined(document.warnings, folder),
                 QByteArray("slider/rail.dat: has no run.dat or dynamics.def beside it; everything but the slider's "
                            "surface has its default\n"
                            "slider/rail.dat: no file gives the slider's mass and inertias: those of a block of AlTiC "
                            "with 4000 kg/m^3 (4000 to 4250 are reported), slider.mass = 1.5 mg, slider.pitch_inertia "
                            "= 2.066e-13 kg m^2, slider.roll_inertia = 1.362e-13 kg m^2"));
        Case expected = defaultsOf(ModelKind::Film);
        expected.slider.length = 1.25e-3;
        expected.slider.width = 1e-3;
        expected.slider.thickness = 3e-4;
        expected.surface = cmlSurface();
        expected.title = "slider";
        // 1.25 x 1 x 0.3 mm of 4000 kg/m^3: 1.5 mg; inertias m (l^2 + b^2)/12.
        expected.slider.mass = 1.5e-6;
        expected.slider.pitchInertia = 2.066e-13;
        expected.slider.rollInertia = 1.362e-13;
        QCOMPARE(firstDifference(document.value, expected), std::string());
    }
    void staticOrDynamic()
    {
        const Folder folder;
        folder.putSample("slider");
        folder.put("slider/dynamics.def", cmlDynamicsText());
        const CaseDocument both = readCmlCase(folder.path("slider"));
        QVERIFY(both.valid());
        QCOMPARE(both.warnings.size(), std::size_t(2)); // and of the mass
        QCOMPARE(QByteArray::fromStdString(both.warnings.front().message),
                 QByteArray("there is also a dynamics.def, which is not read"));
        QCOMPARE(both.value.initial.nominalTrailingEdgeHeight, 8e-9);
        const CaseDocument dynamic = readCmlCase(folder.path("slider/dynamics.def"));
        QVERIFY(dynamic.valid());
        QCOMPARE(joined(dynamic.warnings, folder),
                 QByteArray("slider/dynamics.def: there is also a run.dat, which is not read"));
        QCOMPARE(dynamic.value.initial.nominalTrailingEdgeHeight, 1e-8);
        QCOMPARE(dynamic.value.slider.mass, 1.6e-6);
        fs::remove(folder.path("slider/run.dat"));
        const CaseDocument alone = readCmlCase(folder.path("slider"));
        QCOMPARE(joined(alone.warnings, folder), QByteArray());
        QCOMPARE(firstDifference(alone.value, dynamic.value), std::string());
    }

    void problems_data()
    {
        QTest::addColumn<QByteArray>("rail");
        QTest::addColumn<QByteArray>("run");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* name, const std::string& rail, const std::string& run, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(rail) << QByteArray::fromStdString(run)
                                << QByteArray(problem);
        };
        const std::string rail = cmlRailText();
        const std::string run = cmlRunText();
        row("both files", withLine(rail, 3, "long"), withLine(run, 8, "low"),
            "s/rail.dat:3: the slider's length must be a number, not \"long\"\n"
            "s/run.dat:8: Intial Attitude: hm must be a number, not \"low\"");
        // The first rail's last two corners swapped.
        row("a rail that crosses itself", withLine(withLine(rail, 8, "1e-4 8e-4 1"), 9, "4e-4 8e-4 1"), run,
            "s/rail.dat:5: rail 1: the outline crosses itself");
        row("a rail without an area", withLine(withLine(rail, 8, "7e-4 2e-4 1"), 9, "6e-4 2e-4 1"), run,
            "s/rail.dat:5: rail 1 has no area");
        row("a ramp on a line", withLine(rail, 14, "9.0E-004 3.0E-004 0"), run,
            "s/rail.dat:11: rail 2: the first three corners lie on a line, so that no ramp goes through them");
        row("a profile that turns back", withLine(rail, 25, "0 2e-6 1e-6"), run,
            "s/rail.dat:25: wall profile 1: the distances must ascend; point 3 lies before the point ahead of it");
        row("an empty run.dat", rail, "", "s/run.dat: is empty");
        row("a taper longer than the slider", withLine(rail, 29, "2e-3 1e-2 2e-6"), run,
            "s/rail.dat:29: abs.taper_length: must be at most slider.length (1.25 mm)");
    }
    void problems()
    {
        QFETCH(QByteArray, rail);
        QFETCH(QByteArray, run);
        QFETCH(QByteArray, problem);
        const Folder folder;
        folder.put("s/rail.dat", rail.toStdString());
        folder.put("s/run.dat", run.toStdString());
        const CaseDocument document = readCmlCase(folder.path("s"));
        QCOMPARE(joined(document.problems, folder), problem);
    }
    void pathsThatLeadNowhere()
    {
        const Folder folder;
        folder.put("runs/run.dat", cmlRunText());
        folder.put("old.cml", std::string("\0binary", 7));
        folder.put("empty.cml", "");
        folder.put("large.cml", std::string(maximumCmlFileSize + 1, 'x'));
        fs::create_directories(folder.path("folder.cml"));
        fs::create_directories(folder.path("odd/rail.dat"));
        const auto problem = [&](const char* path) {
            const CaseDocument document = openCase(folder.path(path).string());
            return joined(document.problems, folder);
        };
        QCOMPARE(problem("none.cml"), QByteArray("none.cml: does not exist"));
        QCOMPARE(problem("runs/run.dat"), QByteArray("runs/run.dat: has no rail.dat beside it"));
        QVERIFY(problem("old.cml").startsWith("old.cml: is not an archive of version 7 or 8; the binary files"));
        QCOMPARE(problem("empty.cml"), QByteArray("empty.cml: is empty"));
        QVERIFY(problem("large.cml").startsWith("large.cml: is larger than 16384 KiB"));
        QCOMPARE(problem("folder.cml"), QByteArray("folder.cml: is a directory, not a file"));
        QCOMPARE(problem("odd"), QByteArray("odd/rail.dat: is a directory, not a file"));
        QCOMPARE(problem("."), QByteArray(".: is a directory, not a file"));
    }
    void collinearPointsAreAWarning()
    {
        const Folder folder;
        folder.put("s/rail.dat", withLine(withLine(cmlRailText(), 5, "5 1"), 7, "2e-4 2e-4 1\n4e-4 2e-4 1"));
        folder.put("s/run.dat", cmlRunText());
        const CaseDocument document = readCmlCase(folder.path("s"));
        QVERIFY(document.valid());
        QVERIFY(
            joined(document.warnings, folder)
                .startsWith("s/rail.dat:5: rail 1: corner 2 lies on the line between the corners before and after"));
    }
    void commentsOfAnyBytes()
    {
        std::string comments;
        for (int byte = 0x20; byte < 256; ++byte) comments += static_cast<char>(byte);
        const Folder folder;
        folder.put("s/rail.dat", cmlRailText());
        folder.put("s/run.dat", cmlRunText() + comments + std::string(20000, 'x') + "\n" + std::string(5000, '\n'));
        const CaseDocument document = readCmlCase(folder.path("s"));
        QVERIFY(document.valid());
        QCOMPARE(findInvalidUtf8(document.text), std::string::npos);
        QVERIFY(parseCase(document.text, "case.toml").valid());
    }

    void anyFilmCaseComesBack_data()
    {
        QTest::addColumn<QByteArray>("place");
        QTest::newRow("folder") << QByteArray("out");
        QTest::newRow("archive") << QByteArray("out.cml");
    }
    void anyFilmCaseComesBack()
    {
        QFETCH(QByteArray, place);
        const Folder folder;
        RandomCase random(place.size() == 3 ? 1 : 2);
        RandomSurface surfaces(3);
        for (int round = 0; round < 150; ++round) {
            Case c = defaultsOf(ModelKind::Film);
            random.change(c, round % 3 == 0 ? 0.1 : 0.7);
            const AirBearingSurface surface = surfaces.surface();
            c.surface.rails = surface.rails;
            c.surface.walls = surface.walls;
            c.surface.pointsOfInterest = surface.pointsOfInterest;
            makeSensible(c);
            if (!checkCombinations(c).empty()) continue; // rails that are a hair too thin
            const CmlOutput output = formatCmlCase(c);
            QVERIFY2(output.problem.empty(), output.problem.c_str());
            QCOMPARE(writeCmlCase(folder.path(place.toStdString()), output.members), std::string());
            const CaseDocument document = readCmlCase(folder.path(place.toStdString()));
            QCOMPARE(joined(document.problems, folder), QByteArray());
            if (c.title != Case{}.title) QCOMPARE(firstDifference(document.value, c), std::string());
            QVERIFY(document.value.surface == c.surface);
        }
    }
    void whatTheProgramWillNotSeeIsNamed()
    {
        Case c = defaultsOf(ModelKind::Film);
        c.steady.shearArm = 1.0;
        c.film.scheme = ConvectionScheme::CompleteFlux; // as the power law of the files is read
        c.film.grid = GridKind::Uniform;
        c.air.slip.model = SlipModel::FukuiKaneko;
        // As a block of AlTiC has them.
        c.slider.mass = roundedTo(4000.0 * c.slider.length * c.slider.width * c.slider.thickness, 4);
        c.slider.pitchInertia = 2.066e-13;
        c.slider.rollInertia = 1.362e-13;
        QVERIFY(formatCmlCase(c).keptKeys.empty() && formatCmlCase(c).lost.empty());
        Case related = c;
        related.surface.symmetries = {{0, 0}};
        QVERIFY(!formatCmlCase(related).lost.empty());
        c.slider.mass = 2e-6;
        c.air.slip.model = SlipModel::NewSecondOrder;
        QCOMPARE(formatCmlCase(c).keptKeys, (std::vector<std::string>{"slider.mass", "air.slip"}));
        c.film.scheme = ConvectionScheme::PowerLaw;
        QCOMPARE(formatCmlCase(c).keptKeys, (std::vector<std::string>{"slider.mass", "air.slip", "film.scheme"}));
    }
    void whatHasNoFiles()
    {
        QVERIFY(formatCmlCase(Case{}).problem.starts_with("model is springs"));
        Case c = defaultsOf(ModelKind::Film);
        c.surface.pointsOfInterest.resize(300);
        QCOMPARE(QByteArray::fromStdString(formatCmlCase(c).problem),
                 QByteArray("does not fit into the established program's files: rail.dat:8: more "
                            "than 250 points of interest"));
    }

    void writingLeavesNothingElse()
    {
        const Folder folder;
        const CmlOutput output = formatCmlCase(defaultsOf(ModelKind::Film));
        QCOMPARE(writeCmlCase(folder.path("a/b"), output.members), std::string());
        QCOMPARE(folder.entries("a/b"), (QStringList{"rail.dat", "run.dat"}));
        QCOMPARE(writeCmlCase(folder.path("a/b.cml"), output.members), std::string());
        QCOMPARE(folder.entries("a"), (QStringList{"b", "b.cml"}));
    }
    void writingThatFailsLeavesWhatWasThere()
    {
        const Folder folder;
        const CmlOutput output = formatCmlCase(defaultsOf(ModelKind::Film));
        const auto problem = [&](const char* path) {
            return QByteArray::fromStdString(writeCmlCase(folder.path(path), output.members))
                .replace(QByteArray::fromStdString(folder.path().string()), "");
        };
        folder.put("file", "x");
        QCOMPARE(problem("file"),
                 QByteArray("file: is a file; a folder, a .cml archive or a .toml case file is needed"));
        QVERIFY(problem("file/inside").startsWith("file/inside: cannot be made"));
        QCOMPARE(problem("new/rail.dat"), QByteArray("new/rail.dat: name the folder in which it is to stand"));
        QVERIFY(problem("missing/out.cml").startsWith("missing/out.cml: cannot be written"));
        folder.put("odd/run.dat/inside", "x");
        folder.put("odd/rail.dat", "as it was");
        QCOMPARE(problem("odd"), QByteArray("odd/run.dat: is a directory, not a file"));
        QCOMPARE(folder.entries("odd"), (QStringList{"rail.dat", "run.dat"}));
        QCOMPARE(std::get<std::string>(readTextFile(folder.path("odd/rail.dat"), 100)), std::string("as it was"));
        QCOMPARE(folder.entries(), (QStringList{"file", "odd"}));
    }
};

TOUCHDOWN_TEST(TestCmlCase)

} // namespace test_cml_case

#include "test_cml_case.moc"
