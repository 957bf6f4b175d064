using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Whether the factors of harvester harvest act: what they are factors of grows from none to the default and beyond.</summary>
[Trait("Category", "Heavy")]
public sealed class HarvestFactorTests(ITestOutputHelper output)
{
    /// <summary>Speed above which a vehicle counts as moving, m/s.</summary>
    private const double Moving = 0.5;

    /// <summary>At a factor of 2.5 or 3 there is at least this many times more; less than the factor, because roads fill up.</summary>
    private const double Growth = 1.2;

    /// <summary>A car that does not wander is so near to the middle of its lane; it cuts bends by centimetres.</summary>
    private const double SteadyMetres = 0.05;

    private static readonly string[] WanderFactors = ["0", "1", "3"];

    private static readonly string[] Factors = ProofSize.Of(["--traffic"], ["--lane-changes", "--traffic", "--pedestrians", "--parked"]);

    [Fact]
    public void Wander_moves_the_car_in_its_lane()
    {
        // Without wandering the car still changes lanes, which is an offset too.
        string[] alone = ["--places", "4", "--lane-changes", "0", "--traffic", "0"];
        double[][] offsets =
        [
            .. WanderFactors.Select(factor =>
                Labels(["--wander", factor, .. alone])
                    .Select(label => label.Lanes!.OffsetFromLaneCentreMetres)
                    .OfType<double>()
                    .Select(Math.Abs)
                    .Order()
                    .ToArray()
            ),
        ];

        Assert.InRange(offsets[0].Average(), 0, SteadyMetres);
        // The median: drifts, which take the car as far as the marking at any factor, dominate a mean or a standard deviation.
        AssertGrowth("--wander", [.. offsets.Select(ordered => ordered[ordered.Length / 2])], SteadyMetres);
    }

    [Fact]
    public void Factors_change_what_they_are_factors_of()
    {
        FrameLabel[] none = Labels([.. Factors.SelectMany(factor => new[] { factor, "0" })]);
        FrameLabel[] usual = Labels();

        Assert.All(
            Factors,
            factor =>
            {
                FrameLabel[] most = Labels(factor, factor == "--parked" ? "2.5" : "3");
                AssertGrowth(factor, [.. new[] { none, usual, most }.Select(labels => Measured(factor, labels))], 0);
            }
        );
    }

    private void AssertGrowth(string option, double[] measured, double maxWithout)
    {
        output.WriteLine($"{option} none, default, most: {string.Join(", ", measured.Select(value => value.ToString("F3")))}");
        Assert.InRange(measured[0], 0, maxWithout);
        Assert.True(measured[1] > measured[0], "The default has no more than none.");
        Assert.True(measured[2] > Growth * measured[1], "The greatest factor has hardly more than the default.");
    }

    private static FrameLabel[] Labels(params string[] options)
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        CliRun
            .Of([
                "harvest",
                "--out",
                session,
                "--frames",
                "120",
                "--hz",
                "1",
                "--seed",
                "6",
                "--size",
                "200x150",
                "--detail",
                "plain",
                "--no-report",
                "--no-scenes",
                .. options,
            ])
            .AssertDone();
        return [.. new SessionReader(session).ReadLabels()];
    }

    private static double Measured(string factor, FrameLabel[] labels) =>
        factor switch
        {
            "--lane-changes" => labels.Count(label =>
                label.Ego.Motion!.Manoeuvre is Manoeuvre.LaneChangeLeft or Manoeuvre.LaneChangeRight or Manoeuvre.Overtake
            ),
            "--traffic" => Objects(labels, item => VehicleClasses.AreVehicles(item.Class) && item.Velocity.Length > Moving),
            "--pedestrians" => Objects(labels, item => item.Class == ObjectClass.Pedestrian),
            _ => Standing(labels),
        };

    private static int Objects(FrameLabel[] labels, Func<ObjectLabel, bool> isCounted) =>
        labels.SelectMany(label => label.Objects).Where(isCounted).Select(item => item.Id).Distinct().Count();

    /// <summary>Vehicles that never move; those that wait at a light show it by their brake lights.</summary>
    private static int Standing(FrameLabel[] labels) =>
        labels
            .SelectMany(label => label.Objects)
            .Where(item => VehicleClasses.AreVehicles(item.Class) && item.HasRider != true)
            .GroupBy(item => item.Id)
            .Count(seen => seen.Count() > 2 && seen.All(item => item.Velocity.Length == 0 && item.Lights?.Brake != true));
}
