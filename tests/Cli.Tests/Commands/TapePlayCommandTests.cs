using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Hostile;
using Harvester.Play.Tapes;

namespace Harvester.Cli.Tests.Commands;

/// <summary>tests/Mod.Tests records tapes of the simulated game and plays them.</summary>
public sealed class TapePlayCommandTests : IDisposable
{
    private const int KeyI = 73;
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Tape_without_differences_is_success()
    {
        CliRun run = Play(TapeBytes.Of(TapeBytes.Idle));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal("No difference: 3 ticks, 0 calls, recorded by version 1.2.3\n", run.Out);
    }

    [Fact]
    public void First_difference_is_printed_with_its_tick()
    {
        CliRun run = Play(TapeBytes.Of([.. TapeBytes.Idle.SkipLast(1), new TapeKey(KeyI, false), new TapeTick()]));

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("First difference in tick 3, call 1; before it 3 ticks, 0 calls", run.Out, StringComparison.Ordinal);
        Assert.Contains("  expected: no further call in this event\n  got:      PLAYER_PED_ID()\n", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Tape_without_an_end_is_played_with_a_note()
    {
        CliRun run = Play(TapeBytes.Of(TapeBytes.Idle.SkipLast(1)));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith("The recording was interrupted", run.Out, StringComparison.Ordinal);
        Assert.Contains("No difference: 3 ticks", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Temporary_folder_is_removed()
    {
        string[] before = Directory.GetDirectories(Path.GetTempPath(), "harvester-tape-*");
        Play(TapeBytes.Of(TapeBytes.Every));

        Assert.Empty(Directory.GetDirectories(Path.GetTempPath(), "harvester-tape-*").Except(before));
    }

    [Fact]
    public void Other_files_are_refused()
    {
        byte[] tape = TapeBytes.Of(TapeBytes.Idle);
        byte[] newer = [.. tape];
        newer[TapeBytes.HeadBytes - 1] = 3;
        byte[] damaged = [.. tape];
        damaged[^1] ^= 1;

        Play([]).AssertFailed(ExitCode.BadData, "it is not a tape");
        Play("# a text file\n"u8.ToArray()).AssertFailed(ExitCode.BadData, "it is not a tape");
        Play(newer).AssertFailed(ExitCode.BadData, "version 3 of the format; this program reads versions 1 and 2");
        Play(damaged).AssertFailed(ExitCode.BadData, "does not match its checksum");
        CliRun.Of("tape", "play", _folder.PathOf("missing.tape")).AssertFailed(ExitCode.InputOutput, "missing.tape");
    }

    [Theory]
    [InlineData(TapeFacts.Settings, "[Harvest]\nWidth = 7680\nHeight = 4320\n")]
    [InlineData(TapeFacts.Rig, """{"name": "r", "origin": [0, 0, 0], "cameras": [CAMERAS]}""")]
    public void Pictures_above_the_limit_are_refused(string fact, string text)
    {
        string cameras = string.Join(
            ", ",
            Enumerable
                .Range(0, 3)
                .Select(i => $$"""{"name": "c{{i}}", "position": [0, 1, 1], "verticalFovDegrees": 50, "width": 3840, "height": 2160}""")
        );

        Play(TapeBytes.Of([new TapeFact(fact, text.Replace("CAMERAS", cameras, StringComparison.Ordinal)), new TapeTick()]))
            .AssertFailed(ExitCode.BadData, "exceed the limit of 3840 x 2160 pixels");
    }

    [Theory]
    [InlineData("[Harvest]\nFolder = OUT\n")]
    [InlineData("[Harvest]\nRig = OUT\n")]
    [InlineData("[Plan]\nFile = OUT\nStart = On\n")]
    [InlineData("[Bridge]\nKind = Folder\nFolder = OUT\n")]
    [InlineData("[Harvest]\nFolder=..\n")]
    public void Hostile_settings_write_nothing_outside(string settings)
    {
        string outside = _folder.PathOf("outside");
        Play(
            TapeBytes.Of([
                new TapeFact(TapeFacts.Settings, settings.Replace("OUT", outside, StringComparison.Ordinal)),
                new TapeTick(),
                new TapeKey(85, false),
                new TapeTick(),
                new TapeKey(78, false),
                new TapeTick(),
                new TapeKey(85, false),
                new TapeTick(),
            ])
        );

        Assert.Equal([_folder.PathOf("a.tape")], Directory.GetFileSystemEntries(_folder.Path));
    }

    private CliRun Play(byte[] content)
    {
        File.WriteAllBytes(_folder.PathOf("a.tape"), content);
        return CliRun.Of("tape", "play", _folder.PathOf("a.tape"));
    }
}
