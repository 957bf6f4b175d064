using Xunit.Abstractions;

namespace Harvester.Mod.Tests.Soak;

/// <summary>A long play by keys at random, in a game that does at random whatever a game has ever been seen to do wrong.</summary>
[Trait("Category", "Heavy")]
public sealed class SoakTests(ITestOutputHelper output)
{
    private const int Ticks = 1_000_000;
    private const int TicksOfAGame = 10_000;
    private static readonly int[] BoolSizes = [1, 4, 8];

    [Fact]
    public void A_million_ticks_with_faults_leak_no_exception_or_game_object()
    {
        var tally = new FaultTally();
        long ticks = 0;
        for (int seed = 0; ticks < Ticks; seed++)
        {
            using var driver = new ScriptDriver(
                SoakPlay.IniOf(seed),
                game => game.BoolBytes = BoolSizes[seed % BoolSizes.Length],
                faces: LightTests.TableOfOne
            );
            var play = new SoakPlay(driver, seed, tally);
            while (driver.Game.Frame < TicksOfAGame)
            {
                play.Tick();
            }

            play.End();
            ticks += driver.Game.Frame;
        }

        output.WriteLine($"{ticks} ticks: {tally}");
        tally.AssertAllHappened();
    }
}
