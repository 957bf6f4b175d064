extern alias tapes;

using Harvester.Play.Tapes;
using tapes::Harvester.Tapes;

namespace Harvester.Mod.Tests.Tapes;

/// <summary>Tapes that are whole, with answers that no game gives: the mod's code ends them with a result or refuses them.</summary>
public sealed class HostileTapeTests
{
    private const int Cases = 8;
    private const int ManyCases = 80;
    private const int ChangesOfACase = 20;
    private const string Work = "writing";
    private static readonly float[] Reals = [float.NaN, float.PositiveInfinity, float.MaxValue, float.Epsilon, -1e30f, 0];
    private static readonly int[] Wholes = [int.MinValue, int.MaxValue, -1, 0, 1, 1 << 24];

    /// <summary>The last reading of the clock that a tape may have: a day, in steps of 100 ns.</summary>
    private const long LastClock = 864_000_000_000;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Impossible_answers_end_in_a_result() => AssertResults(37, Cases);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Many_impossible_answers_end_in_a_result() => AssertResults(38, ManyCases);

    [Theory]
    [InlineData(-1)]
    [InlineData(LastClock + 1)]
    [InlineData(long.MinValue)]
    [InlineData(long.MaxValue)]
    public void Impossible_reading_of_the_clock_is_refused(long steps)
    {
        using var tape = new TapeCursor([new TapeTick(), new TapeClock(LastClock), new TapeClock(steps)], CancellationToken.None);

        Assert.IsType<TapeTick>(tape.TakeEvent());
        Assert.Equal(86_400_000, tape.TakeClock());
        Assert.IsType<InvalidDataException>(tape.Fault!.SourceException);
        Assert.Null(tape.TakeEvent());
    }

    [Fact]
    public void Work_that_never_ends_here_is_a_difference()
    {
        using TapeCursor tape = Working(CancellationToken.None);

        Assert.Throws<TapeStoppedException>(() => new PlayedBackground(tape, TimeSpan.Zero).IsDone(Work, () => false));

        Assert.Equal($"{Work} not done after 0 s", tape.Difference!.Got);
    }

    [Fact]
    public void Cancellation_ends_the_wait_for_work()
    {
        using var cancellation = new CancellationTokenSource();
        using TapeCursor tape = Working(cancellation.Token);
        int asked = 0;

        Assert.Throws<TapeStoppedException>(() =>
            new PlayedBackground(tape, Timeout.InfiniteTimeSpan).IsDone(
                Work,
                () =>
                {
                    if (++asked == 3)
                    {
                        cancellation.Cancel();
                    }

                    return false;
                }
            )
        );

        Assert.Equal(3, asked);
        Assert.Null(tape.Difference);
        Assert.Null(tape.TakeEvent());
    }

    /// <summary>A tape on which some work is done.</summary>
    private static TapeCursor Working(CancellationToken cancellation) => new([new TapeWork(Work, true), new TapeTick()], cancellation);

    private static void AssertResults(int seed, int cases)
    {
        var random = new Random(seed);
        int differing = 0;
        for (int i = 0; i < cases; i++)
        {
            var tape = new EditedTape(RecordedGame.Plain);
            for (int change = 0; change < ChangesOfACase; change++)
            {
                int at = random.Next(tape.Entries.Count);
                tape.Entries[at] = Changed(tape.Entries[at], random);
            }

            TapeResult result = RecordedGame.Play(tape.Bytes());
            differing += result.Difference is null ? 0 : 1;
        }

        Assert.InRange(differing, 1, cases);
    }

    private static TapeEntry Changed(TapeEntry entry, Random random) =>
        entry switch
        {
            TapeCall call => call with
            {
                Answer = Changed(call.Answer, random),
                Written = [.. call.Written.Select(slots => (int[])[.. slots.Select(_ => Of(Wholes, random))])],
            },
            TapeGrab grab => grab with { Refusal = grab.Refusal is null ? "refused" : null },
            TapeClock => new TapeClock(random.NextInt64(0, LastClock)),
            _ => entry,
        };

    private static TapeValue Changed(TapeValue value, Random random) =>
        value.Kind switch
        {
            TapeValueKind.False or TapeValueKind.True => TapeValue.Of(value.Kind == TapeValueKind.False),
            TapeValueKind.Whole => TapeValue.Of(Of(Wholes, random)),
            TapeValueKind.Real => TapeValue.Of(Of(Reals, random)),
            TapeValueKind.Vector => TapeValue.Of(Of(Reals, random), Of(Reals, random), Of(Reals, random)),
            _ => TapeValue.Failed(new InvalidOperationException()),
        };

    private static T Of<T>(T[] values, Random random) => values[random.Next(values.Length)];
}
