// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case_files/cml/cml_disk_file.h"

#include <QTemporaryDir>
#include <QTest>

#include <numbers>

#include "core/case/contact_kind.h"
#include "core/case/parameters.h"
#include "core/case_files/case_reader.h"
#include "core/case_files/case_settings.h"
#include "core/case_files/cml/cml_dynamics_file.h"
#include "core/case_files/cml_case.h"
#include "core/physics/contact/adhesion_kind.h"
#include "tests/support/cml_sample.h"
#include "tests/support/test_program.h"

using namespace touchdown;
using namespace touchdown::test;

namespace test_cml_disk_file {

namespace fs = std::filesystem;

struct Reading {
    Case value = defaultsOf(ModelKind::Film);
    CmlParameters parameters{value};
    explicit Reading(const std::string& text)
    {
        value.slider.length = 1.25e-3;
        value.slider.width = 1e-3;
        value.slider.thickness = 0.3e-3;
        parameters.beginFile("dynamics.def");
        readCmlDynamics(text, parameters);
    }
    QByteArray warnings() const { return joined(parameters.warnings); }
};

std::string withValues(std::string_view heading, std::string_view values)
{
    const std::string text = cmlDynamicsText();
    return withLine(text, lineOf(text, heading) + 1, values);
}

class TestCmlDiskFile : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        dynamics_ = withValues("inwave", "1 4 0 2");
        put("rail.dat", cmlRailText());
        put("dynamics.def", dynamics_);
    }

    /// Waves of the disk's waves, those beside the slider at 22 to 24 mm left out.
    void wavesOfTheDisk()
    {
        const Reading r(withValues("nwave", "3 0 0 0 0 0\n0 1e-9 0 1e-4 0 0 0 0 0\n0 2e-9 90 2e-4 0 0 0 0.02 0.03\n"
                                            "0 9e-9 0 1e-4 0 0 0 0.030 0.031"));
        QCOMPARE(r.warnings(), QByteArray());
        const DiskSurface& surface = r.value.diskSurface;
        QCOMPARE(surface.kind, DiskSurfaceKind::Waves);
        QCOMPARE(surface.waveAmplitudes, (std::vector<double>{1e-9, 2e-9}));
        QCOMPARE(surface.waveLengths, (std::vector<double>{1e-4, 2e-4}));
        QCOMPARE(surface.waveAngles, (std::vector<double>{0.0, std::numbers::pi / 2.0}));
        QVERIFY(checkCombinations(r.value).empty());
    }
    void asperitiesOfTheDisk()
    {
        const Reading r(
            withValues("nwave", "0 0 2 0 0 0\n1 5e-9 0 -1e-4 5e-4 1e-5 2e-5\n1 -3e-9 0 2e-4 4e-4 3e-5 3e-5"));
        QVERIFY2(r.warnings().endsWith("y from the inner edge and full sizes"), r.warnings());
        const DiskSurface& surface = r.value.diskSurface;
        QCOMPARE(surface.kind, DiskSurfaceKind::Bumps);
        QCOMPARE(surface.bumpShape, BumpShape::Ellipsoid);
        QCOMPARE(surface.bumpHeights, (std::vector<double>{5e-9, -3e-9}));
        QCOMPARE(surface.bumpX, (std::vector<double>{-1e-4, 2e-4}));
        QCOMPARE(surface.bumpY, (std::vector<double>{5e-4, 4e-4}));
        QCOMPARE(surface.bumpLengths, (std::vector<double>{1e-5, 3e-5}));
        QCOMPARE(surface.bumpWidths, (std::vector<double>{2e-5, 3e-5}));
        QCOMPARE(surface.track, 2.0 * std::numbers::pi * 23e-3); // once in a turn
        QVERIFY(checkCombinations(r.value).empty());
    }
    void bothAndAProfile()
    {
        const std::string waves = withValues("nwave", "1 0 1 0 0 0\n0 1e-9 0 1e-4 0 0 0 0 0\n0 5e-9 0 0 0 1e-5 1e-5");
        const Reading r(withLine(waves, lineOf(waves, "inwave") + 1, "1 500 0 3"));
        const DiskSurface& surface = r.value.diskSurface;
        QCOMPARE(surface.kind, DiskSurfaceKind::Combined);
        QCOMPARE(surface.file, std::string("wave.def"));
        QCOMPARE(surface.bumpShape, BumpShape::Cosine);
        QCOMPARE(surface.rms, 0.0);
        QVERIFY(checkCombinations(r.value).empty());
    }
    /// Where the slider's pads are small enough for cells of a contact patch; a plane slider's edge is not.
    void intermolecularForces()
    {
        const std::string text =
            replaced(cmlDynamicsText(), "*****************End",
                     "***Intermolecular Force Menu***\nimf a b elecpot\n1 1e-19 2e-76 0.5\n*****************End");
        const Reading whole(text);
        QCOMPARE(whole.value.contact, ContactKind::None);
        QVERIFY2(whole.warnings().contains("Intermolecular: not modelled: the forces, because a region of "),
                 whole.warnings());

        Case c = defaultsOf(ModelKind::Film);
        c.slider.length = 1.25e-3;
        c.slider.width = 1e-3;
        c.surface.rails.resize(1);
        c.surface.rails[0].points = {
            {1.2e-3, 0.48e-3, 0}, {1.24e-3, 0.48e-3, 0}, {1.24e-3, 0.52e-3, 0}, {1.2e-3, 0.52e-3, 0}};
        CmlParameters parameters(c);
        readCmlDynamics(text, parameters);
        QCOMPARE(joined(parameters.warnings), QByteArray());
        QCOMPARE(c.contact, ContactKind::Elastic);
        QCOMPARE(c.adhesion.kind, AdhesionKind::VanDerWaals);
        QCOMPARE(c.adhesion.hamakerA, 1e-19);
        QCOMPARE(c.adhesion.hamakerB, 2e-76);
        QCOMPARE(c.adhesion.voltage, 0.5);
        QCOMPARE(c.elastic.patchPitch, 1.6e-4);
    }

    /// The profile is read where the files lie; a case elsewhere finds it by its path, if that is allowed.
    void trackProfile()
    {
        put("wave.def", "0 0 1\n1e-4 1 2\n2e-4 0 1\n3e-4 -1 0\n0 5e-4\n");
        const CaseDocument document = readCmlCase(path("dynamics.def"));
        QCOMPARE(joined(document.problems), QByteArray());
        QCOMPARE(joined(document.warnings), QByteArray());
        QCOMPARE(document.value.diskSurface.kind, DiskSurfaceKind::File);
        QVERIFY(fs::path(document.value.diskSurface.file).is_absolute());
        QVERIFY(parseCase(document.text, "here.toml", path("")).valid());
        QVERIFY(!parseCase(document.text, "elsewhere.toml").valid());
        QVERIFY(parseCase(document.text, "elsewhere.toml", {}, OutsidePaths::Allowed).valid());
    }
    void trackProfileThatCannotBeRead()
    {
        put("WAVE.DEF", "0 0 x\n");
        CaseDocument document = readCmlCase(path("dynamics.def"));
        QCOMPARE(document.problems.size(), std::size_t{1});
        QVERIFY2(document.problems.front().text().find("WAVE.DEF:1: ") != std::string::npos,
                 document.problems.front().text().c_str());
        // With a setting it is read again; a line of the text that is made of the case would be nobody's.
        applySettings(document, {"run.duration = 1 us"});
        QCOMPARE(document.problems.size(), std::size_t{1});
        QVERIFY2(joined(document.problems).endsWith("dynamics.def names this file"), joined(document.problems));
    }
    void trackProfileThatIsNotThere()
    {
        const CaseDocument document = readCmlCase(path("dynamics.def"));
        QVERIFY(document.valid());
        QCOMPARE(document.value.diskSurface.kind, DiskSurfaceKind::Flat);
        QVERIFY2(joined(document.warnings)
                     .endsWith("dynamics.def:43: Disk Track Profile: not modelled: there is no wave.def "
                               "beside this file"),
                 joined(document.warnings));
    }
    void trackProfileOfAnArchive()
    {
        const auto bytes = formatCmlArchive({{"rail.dat", cmlRailText()}, {"dynamics.def", dynamics_}});
        put("a.cml", std::get<std::string>(bytes));
        const CaseDocument document = readCmlCase(path("a.cml"));
        QVERIFY(document.valid());
        QVERIFY2(joined(document.warnings).contains("a wave.def in an archive; unpack it"), joined(document.warnings));
    }

    /// What only the dynamic program would know comes back from the comments of run.dat.
    void thereAndBack()
    {
        put("dynamics.def", withValues("nwave", "1 0 0 0 0 0\n0 1e-9 10 1e-4 0 0 0 0 0"));
        const CaseDocument document = readCmlCase(path("dynamics.def"));
        QVERIFY2(document.valid(), joined(document.problems));
        const CmlOutput output = formatCmlCase(document.value);
        QCOMPARE(output.problem, std::string());
        QVERIFY(std::ranges::count(output.keptKeys, "run.step") == 1);
        QCOMPARE(writeCmlCase(path("back"), output.members), std::string());
        const CaseDocument back = readCmlCase(path("back"));
        QVERIFY2(back.valid(), joined(back.problems));
        for (const char* key :
             {"run.duration", "run.steps", "run.step", "initial.vertical_velocity", "initial.pitch_velocity",
              "suspension.stiffness", "suspension.damping", "suspension.roll_damping", "slider.mass",
              "disk.surface.kind", "disk.surface.wave_amplitudes", "disk.surface.wave_lengths",
              "disk.surface.wave_angles"})
            QVERIFY2(toText(back.value, *findParameter(key)) == toText(document.value, *findParameter(key)), key);
    }

private:
    fs::path path(const char* name) const { return folder_->filePath(name).toStdString(); }
    void put(const char* name, const std::string& text) const { QVERIFY(writeTextFile(path(name), text).empty()); }
    std::unique_ptr<QTemporaryDir> folder_;
    std::string dynamics_;
};

TOUCHDOWN_TEST(TestCmlDiskFile)

} // namespace test_cml_disk_file

#include "test_cml_disk_file.moc"
