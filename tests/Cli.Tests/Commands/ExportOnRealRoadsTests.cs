using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

/// <summary>
/// Datasets of sessions on the slopes of the game's own roads, where camera, car and other objects lean against each other.
/// </summary>
public sealed class ExportOnRealRoadsTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Exports_of_a_session_on_a_hill_are_valid() => AssertValidOnSlopes("-500,700");

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Exports_of_a_session_on_a_mountain_are_valid() => AssertValidOnSlopes("500,5500");

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void OpenLane_lines_near_the_car_lie_on_the_road_on_slopes()
    {
        // Within 10 m the grade of these roads changes by up to 8 %. A level frame would be off by their slopes of 10 % and more at once,
        // and by the model's height.
        const double nearMetres = 10;
        const double roadMetres = 0.08 * nearMetres;
        Harvest("-500,700");
        CliRun.Of("export", _folder.PathOf("session"), "--format", "openlane", "--out", _folder.PathOf("openlane"));

        double[] heights = [.. File.ReadLines(_folder.PathOf("openlane/train.txt")).SelectMany(image => HeightsIn(image, nearMetres))];

        Assert.True(heights.Length > 100);
        Assert.All(heights, height => Assert.InRange(height, -roadMetres, roadMetres));
    }

    private void AssertValidOnSlopes(string near)
    {
        Harvest(near);
        foreach (string format in (string[])["kitti", "kitti-tracking", "openlane"])
        {
            Assert.Equal(
                ExitCode.Done,
                CliRun.Of("export", _folder.PathOf("session"), "--format", format, "--out", _folder.PathOf(format)).ExitCode
            );
            CliRun validate = CliRun.Of("validate", _folder.PathOf(format));
            Assert.True(validate.ExitCode == ExitCode.Done, validate.Out);
        }

        // After the header: objects that lean too far for the format's boxes, without which the slopes would have tested nothing.
        Assert.NotEmpty(File.ReadLines(_folder.PathOf("kitti/training/leaning.csv")).Skip(1));
    }

    /// <summary>Heights in the vehicle's frame of the points that are nearer to its origin, along x and y.</summary>
    private IEnumerable<double> HeightsIn(string image, double within)
    {
        using JsonDocument frame = JsonDocument.Parse(
            File.ReadAllText(_folder.PathOf("openlane/lane3d/" + Path.ChangeExtension(image, ".json")))
        );
        double[][] extrinsic = Rows(frame.RootElement.GetProperty("extrinsic"));
        foreach (JsonElement line in frame.RootElement.GetProperty("lane_lines").EnumerateArray())
        {
            double[][] xyz = Rows(line.GetProperty("xyz"));
            for (int i = 0; i < xyz[0].Length; i++)
            {
                double[] point =
                [
                    .. extrinsic.Take(3).Select(row => (row[0] * xyz[0][i]) + (row[1] * xyz[1][i]) + (row[2] * xyz[2][i]) + row[3]),
                ];
                if (Math.Sqrt((point[0] * point[0]) + (point[1] * point[1])) < within)
                {
                    yield return point[2];
                }
            }
        }
    }

    private static double[][] Rows(JsonElement matrix) =>
        [.. matrix.EnumerateArray().Select(row => row.EnumerateArray().Select(item => item.GetDouble()).ToArray())];

    private void Harvest(string near) =>
        Assert.Equal(
            ExitCode.Done,
            CliRun
                .Of(
                    "harvest",
                    "--out",
                    _folder.PathOf("session"),
                    "--frames",
                    "20",
                    "--seed",
                    "3",
                    "--hz",
                    "1",
                    "--size",
                    "480x300",
                    "--no-report",
                    "--roads",
                    RealWorldFactAttribute.PathOf("nodes.zip")!,
                    $"--near={near}"
                )
                .ExitCode
        );
}
