using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Imu;

/// <summary>The samples of a harvest's inertial unit, integrated from the first frame on, lead to the poses of the later ones.</summary>
public sealed class ImuHarvestTests(ITestOutputHelper output)
{
    private const int Frames = 20;
    private const double RateHz = 1;

    /// <summary>The rounding of doubles over 20 s of samples.</summary>
    private const double Rounding = 1e-8;

    /// <summary>
    /// Over a tick, the integral takes the mean of the velocities at both ends. Where a road bends, the car leaves that straight line
    /// by the acceleration times dt² / 12, less than 0.3 mm a tick; these add up to less than 2 cm in 20 s.
    /// </summary>
    private const double PositionMetres = 0.02;

    [Theory]
    [InlineData(9201)]
    [InlineData(9202)]
    [Trait("Category", "Heavy")]
    public void Samples_integrate_back_to_the_poses_of_frames(int seed)
    {
        QuaternionIntegrator? integrated = null;
        (double attitude, double velocity, double position, double travelled) = (0, 0, 0, 0);
        var before = default(Vector3D);
        int samples = 0;
        foreach (FrameLabel label in Harvest(seed))
        {
            ImuLabel imu = label.Channels.Get<ImuLabel>()!;
            Axes axes = label.Ego.Axes!.Value;
            if (integrated is null)
            {
                integrated = new QuaternionIntegrator(axes, label.Ego.Velocity, label.TimeSeconds, label.Ego.Position);
            }
            else
            {
                foreach (ImuSample sample in imu.Samples)
                {
                    integrated.Add(sample);
                }

                samples += imu.Samples.Count;
                travelled += (label.Ego.Position - before).Length;
                Assert.Equal(label.TimeSeconds, imu.Samples[^1].TimeSeconds, 1e-9);
            }

            before = label.Ego.Position;
            attitude = Math.Max(attitude, (integrated.ToWorld(new Vector3D(0, 1, 0)) - axes.Forward).Length);
            attitude = Math.Max(attitude, (integrated.ToWorld(new Vector3D(0, 0, 1)) - axes.Up).Length);
            velocity = Math.Max(velocity, (integrated.Velocity - label.Ego.Velocity).Length);
            position = Math.Max(position, (integrated.Position - label.Ego.Position).Length);
        }

        output.WriteLine(
            FormattableString.Invariant(
                $"seed {seed}: {samples} samples, {travelled:0} m; attitude {attitude:0.0e0} rad, velocity {velocity:0.0e0} m/s, "
            ) + FormattableString.Invariant($"position {position:0.000} m")
        );
        Assert.True(travelled > 25);
        Assert.InRange(samples, (Frames - 1) * 60 / RateHz, (Frames + 1) * 60 / RateHz);
        Assert.InRange(attitude, 0, Rounding);
        Assert.InRange(velocity, 0, Rounding);
        Assert.InRange(position, 0, PositionMetres);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Unit_does_not_change_what_else_is_recorded()
    {
        FrameLabel label = Harvest(21, frames: 2).Last();

        Assert.Null(label.Motion);
        Assert.Equal(60, label.Channels.Get<ImuLabel>()!.Samples.Count);
    }

    private static List<FrameLabel> Harvest(int seed, int frames = Frames)
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = seed, IsWarm = true });
        var labels = new List<FrameLabel>();
        LabelledTown.Harvest(
            game,
            game.Ports,
            new HarvestOptions
            {
                Image = new ImageSize(40, 30),
                MaxFrames = frames,
                RateHz = RateHz,
                RangeMetres = 10,
                Channels = new ChannelKeys([FrameChannels.Imu.Key]),
            },
            (frame, _) => labels.Add(frame.Label)
        );
        Assert.Equal(frames, labels.Count);
        return labels;
    }
}
