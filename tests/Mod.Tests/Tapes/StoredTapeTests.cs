extern alias tapes;

using tapes::Harvester.Tapes;

namespace Harvester.Mod.Tests.Tapes;

/// <summary>
/// Tapes of the simulated game that this mod and earlier ones recorded by <see cref="RecordedGame.Harvest"/>. A change of the format, or of
/// what a playback compares, shows at all of them; a change of what the mod asks for shows at the newest. GTADATAHARVESTER_TAPE names a
/// file to which the tape of this mod is written; docs/tape.md says when.
/// </summary>
public sealed class StoredTapeTests
{
    private const string TapeVariable = "GTADATAHARVESTER_TAPE";

    /// <summary>The tape that plays to its end.</summary>
    private const string Newest = "harvest-rays.tape";

    [Theory]
    [InlineData("harvest-1.0.tape", 1, 19, "HIDE_HUD_AND_RADAR_THIS_FRAME()", "GET_GAME_TIMER()")]
    [InlineData("harvest-riders.tape", 1, 19, "HIDE_HUD_AND_RADAR_THIS_FRAME()", "GET_GAME_TIMER()")]
    public void Older_tape_plays_up_to_the_first_new_question(string name, int ticks, long calls, string expected, string got)
    {
        TapeResult result = Play(name);

        var difference = new TapeDifference(ticks + 1, calls + 1, expected, got);
        Assert.Equal(new TapeResult(ticks, calls, false, result.RecordedBy, difference), result);
    }

    [Fact]
    public void Newest_tape_plays_to_its_end()
    {
        if (Environment.GetEnvironmentVariable(TapeVariable) is { Length: > 0 } file)
        {
            File.WriteAllBytes(file, RecordedGame.Plain);
        }

        TapeResult result = Play(Newest);

        Assert.Null(result.Difference);
        Assert.False(result.IsInterrupted);
        Assert.Equal(RecordedGame.Ticks + 2, result.Ticks);
    }

    private static TapeResult Play(string name) =>
        RecordedGame.Play(File.ReadAllBytes(Path.Combine(BuiltMod.RepositoryRoot, "tests", "Mod.Tests", "Tapes", name)));
}
