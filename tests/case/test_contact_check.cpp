// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/contact_check.h"

#include <QTest>

#include "core/case/contact_kind.h"
#include "tests/support/test_program.h"

using namespace touchdown;

namespace test_contact_check {

class TestContactCheck : public QObject {
    Q_OBJECT

private slots:
    void findsNonsense_data()
    {
        QTest::addColumn<QStringList>("settings"); // key=value
        QTest::addColumn<QString>("key");          // "" : it makes sense
        QTest::addColumn<QString>("part");         // of the message
        const auto row = [](const char* name, const QStringList& settings, const char* key, const char* part) {
            QTest::newRow(name) << settings << QString(key) << QString(part);
        };
        row("the default", {}, "", "");
        row("no contact", {"contact=none"}, "contact", "must not be \"none\"");
        row("nowhere to go", {"approach.closest=5 nm"}, "approach.closest",
            "5 nm must be less than approach.start (5 nm)");
        row("take-off below touch-down", {"contact=ono-yamane", "ono_yamane.take_off=2 nm"}, "ono_yamane.take_off",
            "d_e = 2 nm must be at least");
        row("bridges shorter than the film", {"contact=multi-asperity", "meniscus.breaking_length=0.4 nm"},
            "meniscus.breaking_length", "must be at least meniscus.film_thickness (0.5 nm)");
        row("bridges shorter than the film under a slider",
            {"model=film", "degrees_of_freedom=3", "contact=multi-asperity", "meniscus.breaking_length=0.4 nm"},
            "meniscus.breaking_length", "must be at least meniscus.film_thickness (0.5 nm)");
        row("a pad longer than its slider",
            {"model=film", "degrees_of_freedom=3", "contact=multi-asperity", "pad.length=2 mm"}, "pad.length",
            "must be at most slider.length (1.25 mm)");
        row("a pad as wide as its slider",
            {"model=film", "degrees_of_freedom=3", "contact=multi-asperity", "pad.width=1 mm"}, "", "");
        row("a long pad without a slider", {"contact=multi-asperity", "pad.length=2 mm"}, "", "");
        row("their like in another contact", {"meniscus.breaking_length=0.4 nm"}, "", "");
        row("a pad of half cells", {"pad.length=20.1 um"}, "pad.length",
            "is not a whole number of cells; the nearest length is 20 um");
        row("a pad of one cell", {"pad.width=0.25 um"}, "pad.width", "makes 1 cells; from 2 to 2048 are possible");
        row("a pad of too many cells", {"elastic.cell=0.005 um"}, "pad.length", "makes 4000 cells");
        row("cells of a statistical surface", {"contact=asperity", "pad.length=20.1 um"}, "", "");
        row("a periodic slider", {"pad.shape=slider", "elastic.periodic=true"}, "elastic.periodic", "must be false");
        row("pressed flat and further", {"elastic.periodic=true"}, "approach.closest", "must be greater than 0 nm");
        row("a patch that repeats, not pressed flat", {"elastic.periodic=true", "approach.closest=0.1 nm"}, "", "");
        row("no roughness", {"disk.surface.kind=rough", "disk.surface.rms=0"}, "disk.surface.rms", "must be above 0");
        row("a correlation below the grid step", {"disk.surface.kind=rough", "disk.surface.correlation_length=0.2 um"},
            "disk.surface.correlation_length", "must be at least 0.25 um");
        row("the same on a flat disk", {"disk.surface.correlation_length=0.2 um"}, "", "");
        row("a patch coarser than the roughness", {"disk.surface.kind=rough", "elastic.cell=0.5 um"}, "elastic.cell",
            "0.5 um must be at most disk.surface.cell (0.25 um)");
        row("no waves", {"disk.surface.kind=waves"}, "disk.surface.wave_amplitudes", "at least one wave");
        const QStringList waves{"disk.surface.kind=waves", "disk.surface.wave_amplitudes=1 nm"};
        row("a wave without its length", waves, "disk.surface.wave_lengths", "must be as long as wave_amplitudes");
        row("a wave", waves + QStringList{"disk.surface.wave_lengths=1 um"}, "", "");
        row("a wave of three cells", waves + QStringList{"disk.surface.wave_lengths=0.75 um"}, "elastic.cell",
            "must be at most a quarter of the shortest wave");
        row("no file", {"disk.surface.kind=file"}, "disk.surface.file", "must name");
        row("a combination of nothing", {"disk.surface.kind=combined", "disk.surface.rms=0"}, "disk.surface.kind",
            "no part is given");
        row("too many snapshots", {"run.field_snapshots=10000", "pad.length=200 um", "pad.width=200 um"},
            "run.field_snapshots", "at most 4 GB are possible");
        row("samples apart by more than the run", {"run.sample_interval=3 ms"}, "run.sample_interval",
            "must be at most run.duration");
        row("a spectrum that is not there", {"spectrum.start=2 ms"}, "", "");
        row("springs in elastic contact", {"model=springs"}, "contact",
            "must not be \"elastic\" with model \"springs\": it acts between surfaces");
        const QStringList film{"model=film", "degrees_of_freedom=3"};
        row("a film in elastic contact", film + QStringList{"elastic.cell=0.5 um"}, "", "");
        row("a pad that a film does not have",
            film + QStringList{"elastic.cell=0.5 um", "pad.length=20.1 um", "approach.closest=5 nm"}, "", "");
        row("a film over a characteristic without hysteresis",
            film + QStringList{"contact=ono-yamane", "ono_yamane.take_off=2 nm"}, "ono_yamane.take_off",
            "d_e = 2 nm must be at least");
        row("a film over no roughness",
            film + QStringList{"contact=none", "disk.surface.kind=rough", "disk.surface.rms=0"}, "disk.surface.rms",
            "must be above 0");
        row("a film over roughness, without contact", film + QStringList{"contact=none", "disk.surface.kind=rough"}, "",
            "");
        row("a patch of a film coarser than the roughness",
            film + QStringList{"disk.surface.kind=rough", "elastic.cell=0.5 um"}, "elastic.cell",
            "0.5 um must be at most disk.surface.cell (0.25 um)");
        row("its like without contact",
            film + QStringList{"contact=none", "disk.surface.kind=rough", "elastic.cell=0.5 um"}, "", "");
        row("a surface that moves with a disk that does not",
            film + QStringList{"disk.surface.kind=rough", "disk.speed=0"}, "disk.surface.motion", "take \"still\"");
        row("a surface that is still on a disk that is, too",
            film + QStringList{"contact=none", "disk.surface.kind=rough", "disk.surface.motion=still", "disk.speed=0"},
            "", "");
        // 5 nm/100 urad = 50 um of a flat slider, and its whole width: 4000 cells of 0.25 um.
        row("a trailing edge in too many cells", film, "elastic.patch_reach",
            "can touch, which is more than 2048 cells");
        row("its leading edge", film + QStringList{"elastic.patch_pitch=-100 urad"}, "elastic.patch_reach",
            "take a smaller reach");
        // 2 fields of 192 x 192 cells, 8 bytes each: 0.59 MB a snapshot, 5.9 GB of 10000.
        row("too many snapshots of a film", film + QStringList{"contact=none", "run.field_snapshots=10000"},
            "run.field_snapshots", "at most 4 GB are possible");
        row("many snapshots of a small film",
            film + QStringList{"contact=none", "run.field_snapshots=10000", "film.nodes=97, 97"}, "", "");
    }
    void findsNonsense()
    {
        QFETCH(QStringList, settings);
        QFETCH(QString, key);
        QFETCH(QString, part);
        Case c = defaultsOf(ModelKind::Contact);
        for (const QString& setting : settings) {
            const Parameter* parameter = findParameter(setting.section('=', 0, 0).toStdString());
            QVERIFY(parameter != nullptr);
            QCOMPARE(setFromText(c, *parameter, setting.section('=', 1).toStdString()).value_or(""), std::string());
        }
        const auto problems = checkCombinations(c);
        QVERIFY2(problems.empty() == key.isEmpty(), problems.empty() ? "" : problems.front().message.c_str());
        if (key.isEmpty()) return;
        const auto found = std::ranges::find(problems, key.toStdString(), &CaseProblem::key);
        QVERIFY2(found != problems.end(), problems.front().key.c_str());
        QVERIFY2(QString::fromStdString(found->message).contains(part), found->message.c_str());
    }

    /// W = f_m 2 nm - 2.5 pJ: zero at 1.25 mN. A law without a loop creates nothing.
    void warnsOfCreatedEnergy_data()
    {
        QTest::addColumn<double>("force"); // f_m [N]
        QTest::addColumn<double>("takeOff");
        QTest::addColumn<int>("contact");
        QTest::addColumn<bool>("warns");
        QTest::newRow("W < 0") << 1.2e-3 << 5e-9 << int(ContactKind::OnoYamane) << true;
        QTest::newRow("W > 0") << 1.3e-3 << 5e-9 << int(ContactKind::OnoYamane) << false;
        QTest::newRow("W = 0") << 1.25e-3 << 5e-9 << int(ContactKind::OnoYamane) << false;
        QTest::newRow("no loop") << 0.0 << 3e-9 << int(ContactKind::OnoYamane) << false;
        QTest::newRow("another contact") << 1.2e-3 << 5e-9 << int(ContactKind::None) << false;
    }
    void warnsOfCreatedEnergy()
    {
        QFETCH(double, force);
        QFETCH(double, takeOff);
        QFETCH(int, contact);
        QFETCH(bool, warns);
        Case c;
        c.contact = ContactKind(contact);
        c.onoYamane.meniscusForce = force;
        c.onoYamane.takeOff = takeOff;
        const auto warnings = caseWarnings(c);
        QCOMPARE(!warnings.empty(), warns);
        if (warns) QVERIFY(QString::fromStdString(warnings.front().message).endsWith("W is zero at f_m = 1.25 mN"));
    }

    /// Ranges refuse what each value alone must not be.
    void refusesByRange_data()
    {
        QTest::addColumn<QString>("setting");
        for (const char* setting :
             {"ono_yamane.contact_stiffness=-1", "elastic.modulus=0", "asperity.height_deviation=0",
              "asperity.density=-1", "elastic.poisson_ratio=0.6", "meniscus.breaking_length=0"})
            QTest::newRow(setting) << setting;
    }
    void refusesByRange()
    {
        QFETCH(QString, setting);
        Case c = defaultsOf(ModelKind::Contact);
        const Parameter& parameter = *findParameter(setting.section('=', 0, 0).toStdString());
        const auto problem = setFromText(c, parameter, setting.section('=', 1).toStdString());
        QVERIFY(problem && problem->find("out of range") != std::string::npos);
    }

    /// A slider that lies flat on the disk.
    void tooLargeAPatch()
    {
        Case c = defaultsOf(ModelKind::Contact);
        c.pad.shape = PadShape::Slider;
        c.surface.baseRecess = 0.0;
        c.initial.pitch = 0.0;
        const auto problems = checkCombinations(c);
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems.front().key, std::string("initial.pitch"));
        QVERIFY2(problems.front().message.find("1250 um by 1000 um can touch") != std::string::npos,
                 problems.front().message.c_str());
    }
    void everyProblemIsReported()
    {
        Case c = defaultsOf(ModelKind::Contact);
        c.pad.length = c.pad.width = 20.1e-6;
        c.approach.closest = c.approach.start;
        QCOMPARE(checkCombinations(c).size(), std::size_t{3});
    }
};

TOUCHDOWN_TEST(TestContactCheck)

} // namespace test_contact_check

#include "test_contact_check.moc"
