using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Rendering;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>A stereo pair sees magenta balls in the same rows of its pictures.</summary>
public sealed class EpipolarTests(ITestOutputHelper output)
{
    /// <summary>The requirement.</summary>
    private const double Pixels = 0.3;

    private const double Baseline = 0.54;

    private static readonly ImageSize Image = new(800, 450);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Balls_are_in_the_same_rows_of_both_pictures()
    {
        Rig rig = new(
            "stereo",
            Vector3D.Zero,
            [
                RigHarvest.Camera("left", new Vector3D(-Baseline / 2, 2, 1.2), 0, Image),
                RigHarvest.Camera("right", new Vector3D(Baseline / 2, 2, 1.2), 0, Image),
            ],
            []
        );
        var moment = new RigHarvest(rig, seed: 3);
        moment.Game.Ports.Pause.Freeze();
        Pose ego = moment.Frames[0].Scene!.Snapshot.Ego.Pose;
        double focal = moment.Frames[0].Label.Camera.Fx;
        double worstRow = 0;
        double worstDisparity = 0;
        foreach (
            Vector3D local in new Vector3D[]
            {
                new(0, 6, 1.2),
                new(-1.5, 6, 2.2),
                new(1.6, 7, 0.8),
                new(0.4, 4.5, 1.9),
                new(-0.9, 9, 1.4),
                new(2.4, 9, 3.1),
                new(-2.8, 8, 0.6),
            }
        )
        {
            const double radius = 0.12;
            moment.Game.Ports.Markers!.Show([new PlannedMarker(ego.ToWorld(local), radius, default)]);
            Vector2D left = CentreOf(Draw(moment, rig, 0));
            Vector2D right = CentreOf(Draw(moment, rig, 1));
            worstRow = Math.Max(worstRow, Math.Abs(left.Y - right.Y));

            // The cameras are 2 m ahead of the car's origin.
            worstDisparity = Math.Max(worstDisparity, Math.Abs(left.X - right.X - (focal * Baseline / (local.Y - 2))));
        }

        output.WriteLine(FormattableString.Invariant($"rows {worstRow:0.000} px, disparity {worstDisparity:0.000} px"));
        Assert.InRange(worstRow, 0, Pixels);
        Assert.InRange(worstDisparity, 0, 2 * Pixels);
    }

    private static RenderTarget Draw(RigHarvest moment, Rig rig, int view)
    {
        moment.Game.Ports.RigCamera!.Show(rig.Cameras[view], rig.OnVehicle(rig.Cameras[view].Mount));
        moment.Game.Tick(1.0 / 60);
        return moment.Game.Render(Image);
    }

    /// <summary>The mean place of the magenta pixels.</summary>
    private static Vector2D CentreOf(RenderTarget picture)
    {
        double x = 0;
        double y = 0;
        double weights = 0;
        for (int at = 0; at < picture.Handles.Length; at++)
        {
            // Red and blue well above green: partly covered pixels count in part.
            int green = picture.Colour[(3 * at) + 1];
            double magenta = (Math.Min(picture.Colour[3 * at], picture.Colour[(3 * at) + 2]) - green) / 255.0;
            if (magenta > 0.25)
            {
                x += magenta * ((at % picture.Width) + 0.5);
                y += magenta * ((at / picture.Width) + 0.5);
                weights += magenta;
            }
        }

        Assert.InRange(weights, 20, 5000);
        return new Vector2D(x / weights, y / weights);
    }
}
