using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Freezes a game once with one method, and observes what stands still and whether the camera can be moved.</summary>
internal sealed class FreezeTrial(HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool)
{
    /// <summary>Ticks of the running game before the freeze in which movement is observed.</summary>
    private const int RunningTicks = 3;

    /// <summary>
    /// Ticks for which the world must stand still beyond the picture lag: long enough for slow movement to exceed the tolerance.
    /// </summary>
    private const int StillTicks = 20;

    /// <summary>The last ticks of the still world, in which the change of the image is measured.</summary>
    private const int PictureTicks = 10;

    /// <summary>Ticks beyond the picture lag within which a moved camera must appear.</summary>
    private const int CameraTicks = 5;

    /// <summary>
    /// Distance by which the camera is moved, metres: clearly more than a suspension moves a standing car, and far less than a car's width.
    /// </summary>
    private const double ShiftMetres = 0.25;

    private readonly SceneComparison _comparison = new(options.StillToleranceMetres);
    private bool _sawMovement;
    private int? _settleTicks;
    private bool? _holdsEnvironment;
    private bool? _movesCamera;
    private double _pictureChange = double.NaN;

    /// <summary>The finding, after the run.</summary>
    public FreezeFinding Finding =>
        new(game.Pause.Method, _sawMovement, _settleTicks)
        {
            HoldsEnvironment = _holdsEnvironment,
            MovesCamera = _movesCamera,
            PictureChange = double.IsNaN(_pictureChange) ? null : _pictureChange,
        };

    public IEnumerable<WorkStep> Run()
    {
        SceneSnapshot first = reader.Read();
        for (int tick = 0; tick < RunningTicks + options.MaxPictureLagTicks; tick++)
        {
            yield return WorkStep.Tick;
        }

        SceneSnapshot last = reader.Read();
        _sawMovement = !_comparison.CameraStands(first, last) || _comparison.FirstDifference(first.Entities, last.Entities) is not null;
        PixelBuffer reference = pool.Rent();
        PixelBuffer current = pool.Rent();
        game.Pause.Freeze();
        try
        {
            yield return WorkStep.Do(Watch(last, reference, current));

            if (_settleTicks is not null && game.MountedCamera is { } camera)
            {
                yield return WorkStep.Do(TryCamera(camera, reference, current));
            }
        }
        finally
        {
            game.Pause.Unfreeze();
            pool.Return(reference);
            pool.Return(current);
        }
    }

    /// <summary>Waits until the world has stood still long enough, and leaves the last image of it in the reference.</summary>
    private IEnumerable<WorkStep> Watch(SceneSnapshot asked, PixelBuffer reference, PixelBuffer current)
    {
        int stillTicks = options.MaxPictureLagTicks + StillTicks;
        var gate = new StillnessGate(_comparison);
        EnvironmentState environment = asked.Environment;
        bool holdsEnvironment = true;
        bool hasReference = false;
        double change = 0;
        long settled = 0;
        gate.Observe(asked);
        for (int tick = 0; gate.StillTicks < stillTicks; tick++)
        {
            if (tick == options.MaxSettleTicks + stillTicks)
            {
                yield break;
            }

            yield return WorkStep.Tick;
            SceneSnapshot snapshot = reader.Read();
            gate.Observe(snapshot);
            if (gate.StillTicks == 0)
            {
                (environment, holdsEnvironment, hasReference, change) = (snapshot.Environment, true, false, 0);
            }

            holdsEnvironment &= snapshot.Environment == environment;
            if (gate.StillTicks >= stillTicks - PictureTicks)
            {
                double grabbed = ChangeTo(current, hasReference ? reference : current);
                (change, hasReference) = (Math.Max(change, grabbed), true);
                Buffer.BlockCopy(current.Bytes, 0, reference.Bytes, 0, current.Bytes.Length);
            }

            settled = snapshot.GameFrame - gate.StillTicks - asked.GameFrame;
        }

        _settleTicks = (int)settled;
        _holdsEnvironment = holdsEnvironment;
        _pictureChange = change;
    }

    private IEnumerable<WorkStep> TryCamera(IMountedCamera camera, PixelBuffer reference, PixelBuffer current)
    {
        Vector3D start = game.World.ReadCamera().Pose.Position;
        double noise = LagRecord.MovementOverNoise * _pictureChange;
        bool isReported = false;
        bool isSeen = false;
        try
        {
            camera.Shift(new Vector3D(ShiftMetres, 0, 0));
            for (int tick = 0; tick < options.MaxPictureLagTicks + CameraTicks && !(isReported && isSeen); tick++)
            {
                yield return WorkStep.Tick;
                isReported |= (game.World.ReadCamera().Pose.Position - start).Length > ShiftMetres / 2;

                // Without an image the reported state cannot be contradicted; nor can it be without an earlier one.
                double change = ChangeTo(current, reference);
                isSeen |= double.IsNaN(change) || double.IsNaN(noise) || change > noise;
            }
        }
        finally
        {
            camera.Shift(Vector3D.Zero);
        }

        _movesCamera = isReported && isSeen;
    }

    /// <summary>Grabs an image and returns its difference to another; NaN if it could not be grabbed.</summary>
    private double ChangeTo(PixelBuffer picture, PixelBuffer other) =>
        game.Screen.Grab(picture).IsGood ? PictureDifference.MeanOf(other, picture) : double.NaN;
}
