using System.Globalization;
using Harvester.Exports.Assembly;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Euroc;

/// <summary>EuRoC sequences have the session's images, samples and states, in EuRoC's frames.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class EurocExportTests(SimulatedSession simulated) : CheckTests(simulated, "euroc")
{
    private const string Sequence = "train/0000/mav0";
    private const string Imu = $"{Sequence}/imu0/data.csv";
    private const string States = $"{Sequence}/state_groundtruth_estimate0/data.csv";

    /// <summary>Numbers of the export have at least 4 decimals; those of a rotation 9.</summary>
    private const double Rounding = 1e-4;

    private readonly SimulatedSession _simulated = simulated;

    [Fact]
    public void Samples_and_states_are_those_of_the_session()
    {
        Export();
        FrameLabel[] labels = [.. _simulated.OpenWithFlow().ReadLabels()];
        ImuSample[] samples = [.. labels.SelectMany(label => label.Channels.Get<ImuLabel>()!.Samples)];
        double[][] rows = Rows(Imu);
        double[][] states = Rows(States);

        Assert.Equal((samples.Length, labels.Length), (rows.Length, states.Length));
        Assert.All(
            samples.Zip(rows),
            pair =>
            {
                (ImuSample sample, double[] row) = pair;
                Assert.Equal(sample.TimeSeconds, row[0] / 1e9, 1e-6);
                AssertNear([sample.AngularRate.Y, -sample.AngularRate.X, sample.AngularRate.Z], row[1..4]);
                AssertNear([sample.SpecificForce.Y, -sample.SpecificForce.X, sample.SpecificForce.Z], row[4..]);
            }
        );
        Assert.All(
            labels.Zip(states),
            pair =>
            {
                (EgoLabel ego, double[] row) = (pair.First.Ego, pair.Second);
                Assert.Equal(pair.First.TimeSeconds, row[0] / 1e9, 1e-6);
                AssertNear([ego.Position.X, ego.Position.Y, ego.Position.Z], row[1..4]);
                AssertNear([ego.Velocity.X, ego.Velocity.Y, ego.Velocity.Z], row[8..11]);

                // The first column of the rotation matrix of the quaternion is where x leads, which is forward.
                (double w, double x, double y, double z) = (row[4], row[5], row[6], row[7]);
                Vector3D forward = ego.Axes!.Value.Forward;
                AssertNear(
                    [forward.X, forward.Y, forward.Z],
                    [1 - (2 * ((y * y) + (z * z))), 2 * ((x * y) + (w * z)), 2 * ((x * z) - (w * y))]
                );
                AssertNear(new double[6], row[11..]);
            }
        );
    }

    [Fact]
    public void Every_image_is_listed_with_its_time()
    {
        ExportResult result = Folder.Export("euroc", _simulated.OpenWithFlow());
        string[] lines = Folder.Lines($"out/{Sequence}/cam0/data.csv");
        FrameLabel[] labels = [.. _simulated.OpenWithFlow().ReadLabels()];

        Assert.Equal(result.Frames + 1, lines.Length);
        Assert.All(
            labels.Zip(lines.Skip(1)),
            pair =>
                Assert.Equal(
                    File.ReadAllBytes(Path.Combine(_simulated.OpenWithFlow().Folder, pair.First.Image)),
                    File.ReadAllBytes(Folder.PathOf($"out/{Sequence}/cam0/data/{pair.Second.Split(',')[1]}"))
                )
        );
    }

    [Fact]
    public void Session_without_an_inertial_unit_is_refused()
    {
        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export("euroc", _simulated.Open()));

        Assert.EndsWith(
            "frame 0: it has no samples of an inertial unit, which euroc needs. Harvest with --imu.",
            refused.Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Sample_without_a_number_is_found() =>
        AssertDamageIsFound(Imu, "^([0-9]+,[^,]+),[^,]+", "$1", $"{Imu}, line 2: it has not 6 numbers after its time.");

    [Fact]
    public void Sample_out_of_order_is_found() =>
        AssertDamageIsFound(Imu, "^[0-9]+", "99999999999999", $"{Imu}, line 3: its time is no number, or not after");

    [Fact]
    public void Attitude_that_is_no_rotation_is_found() =>
        AssertDamageIsFound(States, "^([0-9]+,[^,]+,[^,]+,[^,]+),[^,]+", "$1,2", $"{States}, line 2: its quaternion is not of length 1.");

    [Fact]
    public void Lost_table_is_found() => AssertLossIsFound(Imu, $"{Imu}: it is missing.");

    private double[][] Rows(string name) =>
        [
            .. Folder
                .Lines($"out/{name}")
                .Skip(1)
                .Select(line => line.Split(',').Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray()),
        ];

    private static void AssertNear(double[] expected, double[] found)
    {
        Assert.Equal(expected.Length, found.Length);
        Assert.All(expected.Zip(found), pair => Assert.Equal(pair.First, pair.Second, Rounding));
    }
}
