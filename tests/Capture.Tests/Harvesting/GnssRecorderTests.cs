using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>Samples of the satellite receiver: when they are taken, and their errors.</summary>
public sealed class GnssRecorderTests
{
    private const double MetresPerDegree = 111_000;

    /// <summary>The first tick of each tenth: of ticks at 0, 1/60 ... those at 0, 6/60, 12/60 s.</summary>
    [Fact]
    public void Samples_are_taken_ten_times_a_second()
    {
        var recorder = new GnssRecorder(null);
        for (int tick = 0; tick <= 12; tick++)
        {
            recorder.Add(tick / 60.0, At(new Vector3D(tick, 0, 0)));
        }

        Assert.Equal([0, 0.1], recorder.TakeThrough(0.15).Select(sample => Math.Round(sample.TimeSeconds, 9)));
        GnssSample last = Assert.Single(recorder.TakeThrough(1));
        Assert.Equal(0.2, last.TimeSeconds, 9);
        Assert.Equal(Wgs84.Of(new Vector3D(12, 0, 0)), (last.LatitudeDegrees, last.LongitudeDegrees, last.Altitude));
        Assert.Equal(new Vector3D(1, 2, 3), last.Velocity);
    }

    [Fact]
    public void A_game_that_was_loaded_again_begins_anew()
    {
        var recorder = new GnssRecorder(null);
        recorder.Add(5, At(Vector3D.Zero));
        recorder.Restart();
        recorder.Add(1, At(Vector3D.Zero));

        Assert.Equal([1.0], recorder.TakeThrough(9).Select(sample => sample.TimeSeconds));
    }

    /// <summary>
    /// The Allan deviation of a record of 10,000 s at 10 Hz. White noise of the deviation σ in each sample gives σ / √m for clusters of m,
    /// a bias that walks by K gives K √(τ/3) (IEEE Std 952-1997, annex C). Between samples the walk is 0.2 % of the variance; it is read
    /// from a receiver without white noise, whose 1,000 clusters of 10 s give the deviation to about 4 %.
    /// </summary>
    [Theory]
    [InlineData(21)]
    [InlineData(22)]
    public void Allan_deviation_gives_the_parameters_back(int seed)
    {
        const double spread = 0.1;
        double[][] errors = Errors(
            new GnssNoise
            {
                Horizontal = 1.5,
                Vertical = 3,
                HorizontalWalk = 0.3,
                VerticalWalk = 0.6,
                Velocity = 0.05,
                Seed = seed,
            }
        );
        double[][] walked = Errors(
            new GnssNoise
            {
                HorizontalWalk = 0.3,
                VerticalWalk = 0.6,
                Seed = seed,
            }
        );
        for (int axis = 0; axis < 3; axis++)
        {
            (double white, double walk) = axis < 2 ? (1.5, 0.3) : (3, 0.6);
            Assert.InRange(AllanDeviation(errors[axis], 1) / white, 1 - spread, 1 + spread);
            Assert.InRange(AllanDeviation(walked[axis], 100) / Math.Sqrt(10 / 3.0) / walk, 1 - spread, 1 + spread);
            Assert.InRange(AllanDeviation(errors[axis + 3], 1) / 0.05, 1 - spread, 1 + spread);
        }
    }

    /// <summary>Errors to the east, north and up, metres, and of the velocity, m/s, of a receiver at rest in the origin.</summary>
    private static double[][] Errors(GnssNoise noise)
    {
        const int count = 100_000;
        var recorder = new GnssRecorder(noise);
        EgoState ego = At(Vector3D.Zero);
        var samples = new List<GnssSample>();
        for (int i = 0; i < count; i++)
        {
            recorder.Add(i / GnssRecorder.RateHz, ego);
            samples.AddRange(recorder.TakeThrough(double.PositiveInfinity));
        }

        Assert.Equal(count, samples.Count);

        // Near the origin a degree is as many metres as between two places a metre apart.
        double perLatitude = 1 / (Wgs84.Of(new Vector3D(0, 1, 0)).LatitudeDegrees - Wgs84.OriginLatitudeDegrees);
        double perLongitude = 1 / (Wgs84.Of(new Vector3D(1, 0, 0)).LongitudeDegrees - Wgs84.OriginLongitudeDegrees);
        Assert.InRange(perLatitude, 0.9 * MetresPerDegree, 1.1 * MetresPerDegree);
        return
        [
            [.. samples.Select(sample => (sample.LongitudeDegrees - Wgs84.OriginLongitudeDegrees) * perLongitude)],
            [.. samples.Select(sample => (sample.LatitudeDegrees - Wgs84.OriginLatitudeDegrees) * perLatitude)],
            [.. samples.Select(sample => sample.Altitude)],
            [.. samples.Select(sample => sample.Velocity.X - 1)],
            [.. samples.Select(sample => sample.Velocity.Y - 2)],
            [.. samples.Select(sample => sample.Velocity.Z - 3)],
        ];
    }

    /// <summary>The root of half the mean squared difference of the means of neighbouring clusters.</summary>
    private static double AllanDeviation(double[] values, int cluster)
    {
        double[] means =
        [
            .. Enumerable.Range(0, values.Length / cluster).Select(at => values[(at * cluster)..((at + 1) * cluster)].Average()),
        ];
        return Math.Sqrt(means.Zip(means.Skip(1), (a, b) => (b - a) * (b - a)).Average() / 2);
    }

    private static EgoState At(Vector3D place) => new(1, "car", new Pose(place, Axes.Identity), new Vector3D(1, 2, 3));
}
