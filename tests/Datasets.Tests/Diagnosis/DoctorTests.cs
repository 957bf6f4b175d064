using Harvester.Datasets.Diagnosis;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Tests.Diagnosis;

/// <summary>
/// Each log is one as it is found on a player's computer; the doctor must name the cause that the log was made for, first.
/// </summary>
public sealed class DoctorTests : IDisposable
{
    private const string Versions = "2026-10-02 18:03:11 GtaDataHarvester 0.1.0.0, API 3.7.0.181, GTA V Legacy 1.0.3788.0.\n";
    private const string Header =
        Versions
        + "2026-10-02 18:03:11 System: Microsoft Windows NT 6.2.9200.0, runtime 4.0.30319.42000.\n"
        + "2026-10-02 18:03:11 Window: 1920 x 1080, borderless, 96 dpi.\n"
        + "2026-10-02 18:03:11 Changed settings: none.\n";

    private const string Loader =
        "[18:02:59] [DEBUG] Loading API from .\\ScriptHookVDotNet3.dll ...\n"
        + "[18:03:00] [DEBUG] Loading scripts from C:\\Games\\GTA\\scripts ...\n"
        + "[18:03:00] [DEBUG] Loading assembly GtaDataHarvester.dll ...\n"
        + "[18:03:00] [INFO] Found 1 script(s) in GtaDataHarvester.dll resolved to API 3.7.0.\n"
        + "[18:03:01] [INFO] Started script Harvester.Mod.HarvesterScript.\n";

    private const string Hook =
        "// GTA V SCRIPT HOOK (build Mar  4 2026, v1.0.3788.0)\n"
        + "[18:02:40] INIT: Started\n"
        + "[18:02:41] INIT: Success, game version is VER_1_0_3788_0\n"
        + "[18:02:41] INIT: Registering script 'ScriptHookVDotNet.asi' (0x00007FFC47631480)\n";

    private readonly string _game = Directory.CreateTempSubdirectory("doctor").FullName;

    public DoctorTests() => Directory.CreateDirectory(Scripts);

    private string Scripts => Path.Combine(_game, "scripts");

    public static TheoryData<string, string> ModProblems =>
        new()
        {
            { "The harvest ended: 0 frames, discarded: 50 black, in C:\\out.", "black" },
            { "The harvest ended: 3 frames, discarded: 2 cameraMoved, 40 covered, in C:\\out.", "covered the game's window" },
            { "The harvest ended: 1 frame, discarded: 9 neverStill, in C:\\out.", "kept moving" },
            { "The harvest ended: 0 frames, discarded: 5 strange, in C:\\out.", "for the reason strange" },
            {
                "The camera model is off by 3.1 px, more than the 1.0 px allowed. Calibrate the camera first.",
                "does not fit the camera model"
            },
            {
                "The camera model cannot be checked, as only 3 of 12 markers are seen: give the camera a free view.",
                "Too few calibration markers"
            },
            {
                "The picture is 7 ticks behind the game, and the harvest allows for 4. Raise the limit (MaxPictureLagTicks) "
                    + "and start again.",
                "lags behind the game by more than the harvest allows"
            },
            {
                "The harvest failed: The image is 1 tick behind the game; the harvest allows 0.",
                "lags behind the game by more than the harvest allows"
            },
            { "The harvest failed: The fwScriptGuid pool is full. More in GtaDataHarvester.log.", "script handles is full" },
            { "The drive failed: Address already in use More in GtaDataHarvester.log.", "port of the bridge" },
            { "The harvest stopped: There is not enough space on the disk.", "disk is full" },
            {
                "The harvest failed: Access to the path 'C:\\out' is denied. More in GtaDataHarvester.log.",
                "does not allow the game to write"
            },
            { "GtaDataHarvester.ini: Line 7: Rate = fast is not a number from 0.01 to 60; the default is used.", "A setting" },
            { "The game has no vehicle 'addder'. Change Model under [TestCar] in GtaDataHarvester.ini.", "no vehicle 'addder'" },
            {
                "The world stood still neither while the game was paused nor at a time scale of 0: most frames will be discarded.",
                "Neither freeze method"
            },
            {
                "The overlay failed: Object reference not set to an instance of an object. More in GtaDataHarvester.log.",
                "The overlay failed unexpectedly"
            },
            { "Window: 2560 x 1440, exclusive full screen, 144 dpi.", "exclusive full screen" },
            {
                "No tick for 12.3 s: the game was paused. Switch off Pause Game On Focus Loss under Settings, Graphics, and so on.",
                "stopped for 12.3 s"
            },
            {
                "Settings of the game harm pictures and labels: MSAA is 4. Change them under Settings, Graphics.",
                "harm pictures and labels: MSAA is 4."
            },
            {
                "Masks come from rays: hidden objects still show in the picture of the frozen game after 8 ticks.",
                "come from rays instead"
            },
            { "The harvest: on", "The log ends while 'The harvest' is on" },
            {
                "The overlay: off after 780 ticks in 31.0 s, 215.0 natives per tick, 0 rays per second, tick time p50 16.10 "
                    + "ms, p99 41.20 ms",
                "'The overlay' makes the game stutter"
            },
        };

    public static TheoryData<string, string> LoaderProblems =>
        new()
        {
            { "[18:03:00] [WARNING] Unable to resolve API version 3.6.0 referenced in GtaDataHarvester.dll.", "older than 3.6.0" },
            {
                "[18:03:00] [ERROR] Unable to load GtaDataHarvester.dll: System.IO.FileLoadException: ... (Exception from "
                    + "HRESULT: 0x80131515)",
                "Windows blocks"
            },
            {
                "[18:03:00] [ERROR] Failed to instantiate script Harvester.Mod.HarvesterScript because constructor threw an exception: "
                    + "System.TypeInitializationException: The type initializer for 'SHVDN.NativeMemory' threw an exception.",
                "does not know this build"
            },
            {
                "[18:03:00] [ERROR] Failed to instantiate script Harvester.Mod.HarvesterScript because constructor threw an exception: "
                    + "System.Exception",
                "failed to start"
            },
            {
                "[18:03:00] [ERROR] Blocking script! Script Harvester.Mod.HarvesterScript (file name: GtaDataHarvester.dll) was terminated "
                    + "because it caused the game to freeze too long.",
                "took so long"
            },
            { "[18:03:00] [ERROR] Script Harvester.Mod.HarvesterScript is not responding! Aborting ...", "took so long" },
            // Releases up to 3.5.1.
            { "[18:03:00] [ERROR] Script 'Harvester.Mod.HarvesterScript' is not responding! Aborting ...", "took so long" },
            { "[18:03:00] [WARNING] Unable to resolve API version 3.6.0.", "older than 3.6.0" },
            { "[18:03:00] [WARNING] Ignoring assembly file GtaDataHarvester.dll because of exception: ...", "cannot be loaded" },
            { "[18:03:00] [ERROR] Failed to load assembly GtaDataHarvester.dll: System.IO.FileNotFoundException", "cannot be loaded" },
            { "[18:03:00] [WARNING] Failed to reload scripts because the .\\scripts directory is missing.", "no folder 'scripts'" },
            { "[18:03:00] [INFO] Found 0 script(s) in GtaDataHarvester.dll.", "cannot be loaded" },
            {
                "[18:03:00] [WARNING] The script name Harvester.Mod.HarvesterScript already exists and was loaded from "
                    + "GtaDataHarvester.dll. "
                    + "Ignoring occurrence",
                "installed twice"
            },
        };

    public void Dispose() => Directory.Delete(_game, recursive: true);

    [Theory]
    [MemberData(nameof(ModProblems))]
    public void Problem_in_the_mods_log_is_named(string line, string cause)
    {
        Write(LogKind.Mod, $"{Header}2026-10-02 18:04:00 {line}\n");

        Finding finding = Assert.Single(Doctor.Examine(Scripts).Findings);
        Assert.Contains(cause, finding.Cause, StringComparison.Ordinal);
        Assert.Equal((5, 1), (finding.Evidence!.Number, finding.Count));
        Assert.Contains(line, finding.Evidence.Text, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(LoaderProblems))]
    public void Problem_in_the_loaders_log_is_named(string line, string cause)
    {
        Write(LogKind.Loader, $"{Loader}{line}\n");

        Assert.Contains(cause, Assert.Single(Examine(LogKind.Loader)).Cause, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("[18:02:41] FATAL: Unknown game version, check http://dev-c.com for updates", "ScriptHookV is older than the game.")]
    [InlineData(
        "[18:02:41] FATAL: Can't find native 0x63606A61DE68898A",
        "A mod calls a native function (0x63606A61DE68898A) that this build of the game does not have."
    )]
    [InlineData(
        "[18:02:41] CORE: An exception occurred while executing 'ScriptHookVDotNet.asi' (0x00007FFC), id 33",
        "ScriptHookVDotNet crashed."
    )]
    [InlineData(
        "[18:02:41] CORE: An exception occurred while executing 'Menyoo.asi' (0x00007FFC), id 33",
        "Another mod crashed: Menyoo.asi."
    )]
    public void Problem_in_the_log_of_ScriptHookV_is_named(string line, string cause)
    {
        Write(LogKind.ScriptHook, $"{Hook}{line}\n");

        Assert.Equal(cause, Assert.Single(Examine(LogKind.ScriptHook)).Cause);
    }

    [Theory]
    [InlineData(false, false, false, false, "ScriptHookV was not loaded")]
    [InlineData(true, false, false, false, "ScriptHookVDotNet was not loaded")]
    [InlineData(true, true, false, false, "found no GtaDataHarvester.dll")]
    [InlineData(true, true, true, false, "The mod wrote no log")]
    [InlineData(true, true, true, true, null)]
    public void Missing_log_shows_what_was_not_loaded(bool hook, bool loader, bool loadsMod, bool mod, string? cause)
    {
        File.WriteAllText(Path.Combine(_game, "GTA5.exe"), string.Empty);
        Write(LogKind.ScriptHook, hook ? Hook : null);
        Write(
            LogKind.Loader,
            !loader ? null
                : loadsMod ? Loader
                : Loader.Replace("GtaDataHarvester", "Other", StringComparison.Ordinal)
        );
        Write(LogKind.Mod, mod ? Header : null);
        string[] causes = [.. Doctor.Examine(_game).Findings.Select(finding => finding.Cause)];

        if (cause is null)
        {
            Assert.Empty(causes);
        }
        else
        {
            Assert.Contains(cause, Assert.Single(causes), StringComparison.Ordinal);
        }

        Assert.Equal(causes, Doctor.Examine(Scripts).Findings.Select(finding => finding.Cause));
    }

    [Theory]
    [InlineData("API 3.6.0.0, GTA V Legacy 1.0.3179.0", null)]
    [InlineData("API 3.6.0.0, GTA V Legacy 1.0.3258.0", "newer than ScriptHookVDotNet knows")]
    [InlineData("API 3.6.0.89, GTA V Legacy 1.0.3258.0", null)]
    [InlineData("API 3.7.0.181, GTA V Enhanced 1.0.1013.17", "does not support Enhanced")]
    [InlineData("API 3.9.0.4, GTA V Enhanced 1.0.1013.17", null)]
    [InlineData("API 3.6.0.0, GTA V Legacy unknown", null)]
    public void Incompatible_versions_are_named(string versions, string? cause)
    {
        Write(LogKind.Mod, $"2026-10-02 18:03:11 GtaDataHarvester 0.1.0.0, {versions}.\n");

        IReadOnlyList<Finding> findings = Examine(LogKind.Mod);
        Assert.Equal(cause is null ? 0 : 1, findings.Count);
        Assert.All(findings, finding => Assert.Contains(cause!, finding.Cause, StringComparison.Ordinal));
    }

    [Fact]
    public void Good_run_has_no_finding()
    {
        Write(
            LogKind.Mod,
            Header
                + """
                2026-10-02 18:03:20 The camera is mounted.
                2026-10-02 18:03:20 The camera: on
                2026-10-02 18:03:21 The harvest: on
                2026-10-02 18:03:24 Freeze = Auto: Paused: the world stood still after 1 ticks, the camera could be moved; TimeScale: the world never stood still; Paused is used.
                2026-10-02 18:04:21 The harvest ended: 400 frames, discarded: 3 objectsChanged, 1 covered, in C:\out.
                2026-10-02 18:04:21 The harvest: off after 3600 ticks in 60.0 s, 402.1 natives per tick, 4000 rays per second, tick time p50 9.10 ms, p99 61.20 ms
                2026-10-02 18:05:21 The camera: off after 7200 ticks in 121.0 s, 1.0 natives per tick, 0 rays per second, tick time p50 0.01 ms, p99 0.02 ms

                """
        );

        Assert.Empty(Examine(LogKind.Mod));
    }

    [Fact]
    public void Only_the_last_run_counts_unless_all_are_requested()
    {
        const string failure = "2026-10-02 18:04:00 The road survey failed: row 3. Repair it or move it away.\n";
        Write(LogKind.Mod, Header + failure + Header + "2026-10-02 18:04:00 The harvest: on\n" + Header);
        string log = PathOf(LogKind.Mod);

        Assert.Empty(Doctor.Examine(log).Findings);
        Assert.Equal(2, Assert.Single(Doctor.Examine(log).Logs).RunsLeftAside);
        Assert.Equal([5, 10], Doctor.Examine(log, allRuns: true).Findings.Select(finding => finding.Evidence!.Number!.Value));
    }

    [Fact]
    public void Repeated_problem_is_counted_and_its_last_line_shown()
    {
        Write(
            LogKind.Mod,
            Header + string.Concat(Enumerable.Repeat("2026-10-02 18:04:00 The harvest ended: 0 frames, discarded: 50 black, in out.\n", 3))
        );

        Finding finding = Assert.Single(Examine(LogKind.Mod));
        Assert.Equal((3, 7), (finding.Count, finding.Evidence!.Number));
    }

    [Theory]
    [InlineData("none", "Remove mods")]
    [InlineData("[Harvest] Freeze = TimeScale", "Freeze = Auto")]
    public void Advice_on_a_moving_frozen_world_depends_on_the_freeze_method(string changes, string advice)
    {
        Write(
            LogKind.Mod,
            Header.Replace("Changed settings: none", $"Changed settings: {changes}", StringComparison.Ordinal)
                + "2026-10-02 18:04:00 The harvest ended: 0 frames, discarded: 50 neverStill, in out.\n"
        );

        Assert.Contains(advice, Assert.Single(Examine(LogKind.Mod)).Advice, StringComparison.Ordinal);
    }

    [Fact]
    public void Logs_are_read_from_the_bottom_up()
    {
        Write(LogKind.ScriptHook, Hook + "[18:02:41] CORE: An exception occurred while executing 'Menyoo.asi', id 33\n");
        Write(LogKind.Loader, Loader + "[18:03:00] [ERROR] Script Harvester.Mod.HarvesterScript is not responding! Aborting ...\n");
        Write(LogKind.Mod, Header + "2026-10-02 18:04:00 The drive failed: Address already in use More in GtaDataHarvester.log.\n");

        Assert.Equal(
            ["ScriptHookV.log", "ScriptHookVDotNet.log", "GtaDataHarvester.log"],
            Doctor.Examine(_game).Findings.Select(finding => finding.Evidence!.File)
        );
    }

    [Fact]
    public void Log_that_the_game_still_writes_is_read()
    {
        using var writer = new FileStream(PathOf(LogKind.Mod), FileMode.Create, FileAccess.Write, FileShare.Read);
        writer.Write("2026-10-02 18:03:11 GtaDataHarvester 0.1.0.0, API 3.6.0.0, GTA V Legacy 1.0.3258.0.\n"u8);
        writer.Flush();

        Assert.Single(Examine(LogKind.Mod));
    }

    [Theory]
    [InlineData("")]
    [InlineData("\0\u0001\uFFFD\n\n")]
    [InlineData("milk\n")]
    public void Log_without_a_line_of_the_mod_is_not_reported_as_good(string text)
    {
        Write(LogKind.Mod, text);

        Assert.Contains("no line of the mod", Assert.Single(Examine(LogKind.Mod)).Cause, StringComparison.Ordinal);
    }

    [Fact]
    public void Renamed_log_is_recognised_by_its_content()
    {
        foreach ((string text, LogKind kind) in new[] { (Hook, LogKind.ScriptHook), (Loader, LogKind.Loader), (Header, LogKind.Mod) })
        {
            string path = Path.Combine(_game, "attachment.txt");
            File.WriteAllText(path, text);
            Assert.Equal(kind, Assert.Single(Doctor.Examine(path).Logs).Kind);
        }
    }

    [Fact]
    public void File_that_is_not_a_log_is_refused()
    {
        string path = Path.Combine(_game, "notes.txt");
        File.WriteAllText(path, "milk\n");

        Assert.Contains(
            "is not a log",
            Assert.Throws<DatasetFormatException>(() => Doctor.Examine(path)).Message,
            StringComparison.Ordinal
        );
        Assert.Contains(
            "neither the game's folder",
            Assert.Throws<DatasetFormatException>(() => Doctor.Examine(_game)).Message,
            StringComparison.Ordinal
        );
        Assert.Throws<FileNotFoundException>(() => Doctor.Examine(Path.Combine(_game, "nothing")));
    }

    private string PathOf(LogKind kind) => Path.Combine(kind == LogKind.Mod ? Scripts : _game, LogFile.NameOf(kind));

    private IReadOnlyList<Finding> Examine(LogKind kind) => Doctor.Examine(PathOf(kind)).Findings;

    private void Write(LogKind kind, string? text)
    {
        if (text is not null)
        {
            File.WriteAllText(PathOf(kind), text);
        }
    }
}
