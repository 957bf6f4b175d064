using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>What the inertial unit measures of motions whose rates and accelerations are known, and its noise.</summary>
public sealed class ImuRecorderTests
{
    private const double Gravity = 9.80665;
    private const double Tick = 1.0 / 60;

    /// <summary>The rounding of doubles, over a minute of samples.</summary>
    private const double Rounding = 1e-9;

    [Fact]
    public void Unit_at_rest_measures_gravity_in_its_own_axes()
    {
        var axes = Axes.FromEuler(new EulerAngles(0.3, -0.2, 2));

        ImuSample sample = Assert.Single(SamplesOf([.. Enumerable.Range(0, 2).Select(tick => (tick * Tick, At(axes, default, default)))]));

        Assert.Equal(Tick, sample.TimeSeconds);
        AssertNear(Vector3D.Zero, sample.AngularRate, Rounding);
        AssertNear(new Vector3D(axes.Right.Z, axes.Forward.Z, axes.Up.Z) * Gravity, sample.SpecificForce, Rounding);
    }

    /// <summary>
    /// At 15 m/s on a circle of 30 m to the left: 0.5 rad/s about up and 7.5 m/s² to the left. The mean over a tick is shorter than that by
    /// the factor sin(x) / x, with x half the angle of a tick: less than 3e-6 of it.
    /// </summary>
    [Fact]
    public void Circle_gives_yaw_rate_and_centripetal_force()
    {
        const double rate = 0.5;
        const double speed = 15;
        const double meanOfTick = 3e-6 * rate * speed;

        ImuSample[] samples = SamplesOf([.. Enumerable.Range(0, 120).Select(tick => (tick * Tick, OnCircle(tick * Tick, speed, rate)))]);

        Assert.Equal(119, samples.Length);
        Assert.All(
            samples,
            sample =>
            {
                AssertNear(new Vector3D(0, 0, rate), sample.AngularRate, Rounding);
                AssertNear(new Vector3D(-rate * speed, 0, Gravity), sample.SpecificForce, meanOfTick);
            }
        );
    }

    /// <summary>A tumbling, accelerating body: what is integrated by quaternions is its attitude and velocity.</summary>
    [Fact]
    public void Samples_integrate_back_to_attitude_and_velocity()
    {
        (double Seconds, EgoState Ego)[] ticks =
        [
            .. Enumerable
                .Range(0, 3600)
                .Select(tick => tick * Tick)
                .Select(time =>
                    (
                        time,
                        At(
                            Axes.FromEuler(new EulerAngles(0.7 * Math.Sin(time), 0.9 * Math.Cos(1.3 * time), 2 * time)),
                            new Vector3D(9 - (9 * Math.Cos(time)), 5 * Math.Sin(2 * time) / 2, -0.5 * Math.Cos(3 * time)),
                            new Vector3D(9 * Math.Sin(time), 5 * Math.Cos(2 * time), 1.5 * Math.Sin(3 * time))
                        )
                    )
                ),
        ];
        var integrated = new QuaternionIntegrator(ticks[0].Ego.Pose.Axes, ticks[0].Ego.Velocity, ticks[0].Seconds);

        ImuSample[] samples = SamplesOf(ticks);

        Assert.Equal(ticks.Length - 1, samples.Length);
        for (int i = 0; i < samples.Length; i++)
        {
            integrated.Add(samples[i]);
            AssertNear(ticks[i + 1].Ego.Velocity, integrated.Velocity, Rounding);
            AssertNear(ticks[i + 1].Ego.Pose.Axes.Forward, integrated.ToWorld(new Vector3D(0, 1, 0)), Rounding);
            AssertNear(ticks[i + 1].Ego.Pose.Axes.Up, integrated.ToWorld(new Vector3D(0, 0, 1)), Rounding);
        }
    }

    [Fact]
    public void Vehicle_put_elsewhere_or_replaced_gives_no_sample()
    {
        EgoState here = At(Axes.Identity, default, default);
        EgoState there = At(Axes.Identity, new Vector3D(1, 0, 0), default);

        Assert.Empty(SamplesOf([(0, here), (Tick, there)]));
        Assert.Empty(SamplesOf([(0, here), (Tick, here with { Handle = 2 })]));
        Assert.Empty(SamplesOf([(0, here), (0.5, here)]));
        Assert.Single(SamplesOf([(0, here), (Tick, there), (2 * Tick, there)]));
    }

    [Fact]
    public void Samples_are_taken_once_up_to_the_time_of_a_frame()
    {
        var recorder = new ImuRecorder(null);
        for (int tick = 0; tick <= 4; tick++)
        {
            recorder.Add(tick * Tick, At(Axes.Identity, default, default));
        }

        Assert.Equal([Tick, 2 * Tick], recorder.TakeThrough(2 * Tick).Select(sample => sample.TimeSeconds));
        Assert.Equal([3 * Tick, 4 * Tick], recorder.TakeThrough(1).Select(sample => sample.TimeSeconds));
    }

    [Fact]
    public void Noise_depends_on_the_seed_alone()
    {
        Assert.Equal(Errors(Noise(5), 100), Errors(Noise(5), 100));
        Assert.NotEqual(Errors(Noise(5), 100), Errors(Noise(6), 100));
    }

    /// <summary>
    /// The Allan deviation of a record of 4,000 s at 50 Hz. White noise of the density N gives N/√τ, a bias that walks by K gives K √(τ/3)
    /// (IEEE Std 952-1997, annex C). At short times the one prevails and at long times the other; each is read where the other one is less
    /// than 2 % of the variance.
    /// </summary>
    [Theory]
    [InlineData(11)]
    [InlineData(12)]
    public void Allan_deviation_gives_the_parameters_back(int seed)
    {
        const double rate = 50;

        // The variance of m pairs of clusters spreads by about √(3/m); with at least 1,300 pairs, the deviation by 2.4 %. This is four
        // times that.
        const double spread = 0.1;
        double[][] errors = Errors(Noise(seed), 200_000, 1 / rate);
        for (int axis = 0; axis < 6; axis++)
        {
            (double white, double walk) = axis < 3 ? (2e-3, 2e-2) : (3e-2, 0.3);
            const int shortCluster = 1;
            const int longCluster = 150;

            double found = AllanDeviation(errors[axis], shortCluster) * Math.Sqrt(shortCluster / rate);
            double walked = AllanDeviation(errors[axis], longCluster) / Math.Sqrt(longCluster / rate / 3);

            Assert.InRange(found / white, 1 - spread, 1 + spread);
            Assert.InRange(walked / walk, 1 - spread, 1 + spread);
        }
    }

    private static ImuNoise Noise(int seed) =>
        new()
        {
            Gyroscope = 2e-3,
            GyroscopeWalk = 2e-2,
            Accelerometer = 3e-2,
            AccelerometerWalk = 0.3,
            Seed = seed,
        };

    /// <summary>The root of half the mean squared difference of the means of neighbouring clusters.</summary>
    private static double AllanDeviation(double[] values, int cluster)
    {
        double[] means =
        [
            .. Enumerable.Range(0, values.Length / cluster).Select(at => values[(at * cluster)..((at + 1) * cluster)].Average()),
        ];
        return Math.Sqrt(means.Zip(means.Skip(1), (a, b) => (b - a) * (b - a)).Average() / 2);
    }

    /// <summary>The errors of a unit at rest, by axis.</summary>
    private static double[][] Errors(ImuNoise noise, int count, double interval = Tick)
    {
        var recorder = new ImuRecorder(noise);
        EgoState ego = At(Axes.Identity, default, default);
        var samples = new List<ImuSample>();
        for (int tick = 0; tick <= count; tick++)
        {
            recorder.Add(tick * interval, ego);
            samples.AddRange(recorder.TakeThrough(double.PositiveInfinity));
        }

        Assert.Equal(count, samples.Count);
        return
        [
            [.. samples.Select(sample => sample.AngularRate.X)],
            [.. samples.Select(sample => sample.AngularRate.Y)],
            [.. samples.Select(sample => sample.AngularRate.Z)],
            [.. samples.Select(sample => sample.SpecificForce.X)],
            [.. samples.Select(sample => sample.SpecificForce.Y)],
            [.. samples.Select(sample => sample.SpecificForce.Z - Gravity)],
        ];
    }

    private static ImuSample[] SamplesOf(IReadOnlyList<(double Seconds, EgoState Ego)> ticks)
    {
        var recorder = new ImuRecorder(null);
        foreach ((double seconds, EgoState ego) in ticks)
        {
            recorder.Add(seconds, ego);
        }

        return [.. recorder.TakeThrough(double.PositiveInfinity)];
    }

    private static EgoState OnCircle(double time, double speed, double rate)
    {
        double angle = rate * time;
        var forward = new Vector3D(-Math.Sin(angle), Math.Cos(angle), 0);
        var right = new Vector3D(Math.Cos(angle), Math.Sin(angle), 0);
        return At(Axes.FromVectors(right, forward, new Vector3D(0, 0, 1)), right * (speed / rate), forward * speed);
    }

    private static EgoState At(Axes axes, Vector3D position, Vector3D velocity) => new(1, "car", new Pose(position, axes), velocity);

    private static void AssertNear(Vector3D expected, Vector3D found, double tolerance) =>
        Assert.True((found - expected).Length <= tolerance, $"{found} is not {expected}");
}
