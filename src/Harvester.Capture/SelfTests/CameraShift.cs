using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;

namespace Harvester.Capture.SelfTests;

/// <summary>Moves the camera of a frozen world up once, and observes when the move is reported and when it is seen.</summary>
internal sealed class CameraShift(SelfTestContext context)
{
    /// <summary>Distance of the move: near things move by many pixels, and the camera stays clear of the vehicle.</summary>
    private static readonly Vector3D Up = new(0, 0, 0.5);

    /// <summary>Pictures of the unmoved world that show how much it changes by itself.</summary>
    private const int StillPictures = 6;

    /// <summary>Ticks beyond the longest lag allowed.</summary>
    private const int SpareTicks = 5;

    /// <summary>A block that moved differs by so much more than it does in pictures of the unmoved world.</summary>
    private const double OverNoise = 2;

    /// <summary>Fraction of the blocks that change with the camera: more than change where one vehicle appears or vanishes.</summary>
    private const double MinChangedFraction = 0.1;

    /// <summary>Ticks until the move was reported; null if it never was.</summary>
    public int? ReportedTicks { get; private set; }

    /// <summary>Ticks until the move was seen; null if it never was.</summary>
    public int? SeenTicks { get; private set; }

    /// <summary>Moves the camera and back; the world is frozen.</summary>
    public IEnumerable<WorkStep> Run(IMountedCamera camera)
    {
        var still = new List<BlockMeans>();
        for (int tick = 0; tick < StillPictures && context.ArePicturesUsable; tick++)
        {
            still.Add(BlockMeans.Of(context.Grab()));
            yield return WorkStep.Tick;
        }

        Vector3D start = context.Game.World.ReadCamera().Pose.Position;
        try
        {
            camera.Shift(Up);
            for (int tick = 1; tick <= PictureLag.MaxTicks + SpareTicks; tick++)
            {
                if (ReportedTicks is not null && (SeenTicks is not null || still.Count == 0))
                {
                    break;
                }

                yield return WorkStep.Tick;
                if ((context.Game.World.ReadCamera().Pose.Position - start).Length > Up.Length / 2)
                {
                    ReportedTicks ??= tick;
                }

                if (still.Count > 0 && SeenTicks is null)
                {
                    double changed = BlockMeans.Of(context.Grab()).ChangedFraction(still, OverNoise, SettledPicture.ChangeLevels);
                    SeenTicks = changed >= MinChangedFraction ? tick : null;
                }
            }
        }
        finally
        {
            camera.Shift(Vector3D.Zero);
        }

        // The picture is the old one again before the next check.
        for (int tick = 0; tick < (SeenTicks ?? 0) + 1; tick++)
        {
            yield return WorkStep.Tick;
        }
    }
}
