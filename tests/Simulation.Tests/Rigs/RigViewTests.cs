using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>The views of a moment compared with pictures that are drawn again from their places while the world stands still.</summary>
public sealed class RigViewTests
{
    /// <summary>An edge between two rows may fall into either in one of the pictures.</summary>
    private const int RowsOfRounding = 1;

    /// <summary>One camera may see the upper end of an object beside a nearer one that hides it from the other.</summary>
    private const double MinShare = 0.8;

    private const int Seed = 3;

    [Fact]
    public void Pictures_show_what_their_cameras_see()
    {
        Rig rig = new(
            "test",
            Vector3D.Zero,
            [
                RigHarvest.Camera("front", new Vector3D(0, 2, 0.6), 0, new ImageSize(160, 120)),
                RigHarvest.Camera("left", new Vector3D(-0.5, 0, 1.2), 90, new ImageSize(120, 90), fovDegrees: 80),
                RigHarvest.Camera("back", new Vector3D(0, -2, 0.8), 180, new ImageSize(96, 96)),
            ],
            []
        );
        var moment = new RigHarvest(rig, Seed);
        moment.Game.Ports.Pause.Freeze();
        foreach ((CapturedFrame frame, RigCamera camera) in moment.Frames.Zip(rig.Cameras))
        {
            RenderTarget again = Draw(moment, rig, camera);

            Assert.Equal(frame.Label.TimeSeconds, moment.Game.Shown.TimeSeconds);
            Assert.Equal(again.Colour, frame.Picture.Bytes);
            Assert.Equal(moment.Game.Shown.Camera.Pose, frame.Label.Camera.Pose);
        }
    }

    [Fact]
    public void Objects_of_a_stereo_pair_are_in_the_same_rows()
    {
        var image = new ImageSize(640, 480);
        Rig rig = new(
            "stereo",
            Vector3D.Zero,
            [
                RigHarvest.Camera("left", new Vector3D(-0.27, 2, 0.6), 0, image),
                RigHarvest.Camera("right", new Vector3D(0.27, 2, 0.6), 0, image),
            ],
            []
        );
        var moment = new RigHarvest(rig, Seed);
        moment.Game.Ports.Pause.Freeze();
        Dictionary<int, (int Top, int Bottom)> left = RowsOf(Draw(moment, rig, rig.Cameras[0]));
        Dictionary<int, (int Top, int Bottom)> right = RowsOf(Draw(moment, rig, rig.Cameras[1]));

        int[] both = [.. left.Keys.Intersect(right.Keys)];
        Assert.NotEmpty(both);
        int same = both.Count(handle => Math.Abs(left[handle].Top - right[handle].Top) <= RowsOfRounding);
        Assert.InRange(same, both.Length * MinShare, both.Length);
    }

    private static RenderTarget Draw(RigHarvest moment, Rig rig, RigCamera camera)
    {
        moment.Game.Ports.RigCamera!.Show(camera, rig.OnVehicle(camera.Mount));
        moment.Game.Tick(1.0 / 60);
        return moment.Game.Render(camera.Image);
    }

    /// <summary>The rows of the objects that are wholly in a picture, and large enough for their upper end not to be hidden.</summary>
    private static Dictionary<int, (int Top, int Bottom)> RowsOf(RenderTarget picture)
    {
        var rows = new Dictionary<int, (int Top, int Bottom)>();
        var cut = new HashSet<int>();
        for (int row = 0; row < picture.Height; row++)
        {
            for (int column = 0; column < picture.Width; column++)
            {
                int handle = picture.Handles[(row * picture.Width) + column];
                if (handle != 0)
                {
                    rows[handle] = (rows.TryGetValue(handle, out (int Top, int Bottom) known) ? known.Top : row, row);
                    if (column == 0 || row == 0 || column == picture.Width - 1 || row == picture.Height - 1)
                    {
                        cut.Add(handle);
                    }
                }
            }
        }

        const int large = 24;
        return rows.Where(pair => !cut.Contains(pair.Key) && pair.Value.Bottom - pair.Value.Top >= large)
            .ToDictionary(pair => pair.Key, pair => pair.Value);
    }
}
