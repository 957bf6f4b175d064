using Harvester.Datasets.Sessions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Whether the factors of harvester harvest act: what they are factors of grows from none to the default and beyond.</summary>
[Trait("Category", "Heavy")]
public sealed class HarvestFactorTests(ITestOutputHelper output)
{
    /// <summary>Speed above which a vehicle counts as moving, m/s.</summary>
    private const double Moving = 0.5;

    /// <summary>At a factor of 2.5 or 3 there is at least so many times more; less than the factor, because roads fill up.</summary>
    private const double Growth = 1.2;

    /// <summary>A car that does not wander is so near to the middle of its lane; it cuts bends by centimetres.</summary>
    private const double SteadyMetres = 0.05;

    // At ten places of this seed, the offset at 3 is no greater than at 1 (1.00 and 1.17 m); at four places hardly anybody is on foot.
    [Theory]
    [InlineData("--wander", "3", 4)]
    [InlineData("--lane-changes", "3", 10)]
    [InlineData("--traffic", "3", 10)]
    [InlineData("--pedestrians", "3", 10)]
    [InlineData("--parked", "2.5", 10)]
    public void Factor_changes_what_it_is_a_factor_of(string option, string most, int places)
    {
        double[] measured = [.. new[] { "0", "1", most }.Select(factor => Measured(option, factor, places))];

        output.WriteLine($"{option} 0, 1, {most}: {string.Join(", ", measured.Select(value => value.ToString("F3")))}");
        Assert.InRange(measured[0], 0, option == "--wander" ? SteadyMetres : 0);
        Assert.True(measured[1] > measured[0], "The default has no more than none.");
        Assert.True(measured[2] > Growth * measured[1], "The greatest factor has hardly more than the default.");
    }

    private static double Measured(string option, string factor, int places)
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");

        // Without wandering the car still changes lanes, which is an offset too.
        string[] alone = option == "--wander" ? ["--lane-changes", "0", "--traffic", "0"] : [];
        CliRun.Of([
            "harvest", "--out", session, "--frames", "120", "--places", $"{places}", "--hz", "1", "--seed", "6", "--size", "200x150",
            "--detail", "plain", "--no-report", "--no-scenes", option, factor, .. alone]).AssertDone();
        FrameLabel[] labels = [.. new SessionReader(session).ReadLabels()];
        return option switch
        {
            "--wander" => Deviation([.. labels.Select(label => label.Lanes!.OffsetFromLaneCentreMetres).OfType<double>()]),
            "--lane-changes" => labels.Count(label =>
                label.Ego.Motion!.Manoeuvre is Manoeuvre.LaneChangeLeft or Manoeuvre.LaneChangeRight or Manoeuvre.Overtake),
            "--traffic" => Objects(labels, item => VehicleClasses.AreVehicles(item.Class) && item.Velocity.Length > Moving),
            "--pedestrians" => Objects(labels, item => item.Class == ObjectClass.Pedestrian),
            _ => Standing(labels),
        };
    }

    private static int Objects(FrameLabel[] labels, Func<ObjectLabel, bool> isCounted) =>
        labels.SelectMany(label => label.Objects).Where(isCounted).Select(item => item.Id).Distinct().Count();

    /// <summary>Vehicles that never move; those that wait at a light show it by their brake lights.</summary>
    private static int Standing(FrameLabel[] labels) => labels.SelectMany(label => label.Objects)
        .Where(item => VehicleClasses.AreVehicles(item.Class) && item.HasRider != true)
        .GroupBy(item => item.Id)
        .Count(seen => seen.Count() > 2 && seen.All(item => item.Velocity.Length == 0 && item.Lights?.Brake != true));

    private static double Deviation(double[] values)
    {
        double mean = values.Average();
        return Math.Sqrt(values.Average(value => (value - mean) * (value - mean)));
    }
}
